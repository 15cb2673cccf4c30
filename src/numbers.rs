//! Numbers for keys: which ones were seen before, and when.

/// Numbers 0, 1, 2, … for pairs of integers, in the order in which they first come.
///
/// A table with open addressing, the only one there is: each instance of the standard library's takes kilobytes of module.
#[derive(Default)]
pub struct Numbers {
    keys: Vec<[i64; 2]>,
    /// Numbers, or `FREE`; a power of two of them, at least half free.
    slots: Vec<u32>,
}

const FREE: u32 = u32::MAX;

impl Numbers {
    pub fn len(&self) -> usize {
        self.keys.len()
    }

    /// The number of a key, a new one if need be.
    pub fn of(&mut self, key: [i64; 2]) -> u32 {
        if 2 * self.keys.len() >= self.slots.len() {
            self.grow();
        }
        let slot = self.slot(key);
        if self.slots[slot] == FREE {
            self.slots[slot] = self.keys.len() as u32;
            self.keys.push(key);
        }
        self.slots[slot]
    }

    /// The number of a key that has one.
    pub fn get(&self, key: [i64; 2]) -> Option<u32> {
        if self.keys.is_empty() {
            return None;
        }
        Some(self.slots[self.slot(key)]).filter(|&number| number != FREE)
    }

    /// Whether a key comes for the first time.
    pub fn is_new(&mut self, key: [i64; 2]) -> bool {
        let before = self.len();
        self.of(key) as usize == before
    }

    /// The slot of a key, or the free one that would be its.
    fn slot(&self, [a, b]: [i64; 2]) -> usize {
        // Fibonacci hashing: the high bits of a product depend on all bits below.
        const FACTOR: u64 = 0x9E37_79B9_7F4A_7C15;
        let mixed = ((a as u64).wrapping_mul(FACTOR).rotate_left(32) ^ b as u64).wrapping_mul(FACTOR);
        let mask = self.slots.len() - 1;
        let mut slot = (mixed >> 32) as usize & mask;
        while self.slots[slot] != FREE && self.keys[self.slots[slot] as usize] != [a, b] {
            slot = (slot + 1) & mask;
        }
        slot
    }

    fn grow(&mut self) {
        self.slots = vec![FREE; (2 * self.slots.len()).max(16)];
        for number in 0..self.keys.len() {
            let slot = self.slot(self.keys[number]);
            self.slots[slot] = number as u32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_keys_have_equal_numbers_and_others_their_own() {
        let key = |k: i64| [k % 37 - 18, (k % 91) << 40];
        let mut numbers = Numbers::default();
        assert_eq!(numbers.get([0, 0]), None);
        let mut seen: Vec<[i64; 2]> = Vec::new();
        for k in 0..5000 {
            let known = seen.iter().position(|&other| other == key(k));
            assert_eq!(numbers.get(key(k)), known.map(|number| number as u32));
            assert_eq!(numbers.of(key(k)) as usize, known.unwrap_or(seen.len()));
            assert!(!numbers.is_new(key(k)));
            if known.is_none() {
                seen.push(key(k));
            }
        }
        assert_eq!((numbers.len(), seen.len()), (37 * 91, 37 * 91));
    }
}
