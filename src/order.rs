//! Sorting by numbers, in one instance: each of the standard library's sorts takes eight kilobytes of module.

/// The places of the keys in ascending order; equal ones stay in theirs. By merging longer and longer runs.
pub fn ascending(keys: &[f64]) -> Vec<u32> {
    let count = keys.len();
    let mut order: Vec<u32> = (0..count as u32).collect();
    let mut merged = order.clone();
    let mut run = 1;
    while run < count {
        for first in (0..count).step_by(2 * run) {
            let (middle, last) = ((first + run).min(count), (first + 2 * run).min(count));
            let (mut left, mut right) = (first, middle);
            for place in &mut merged[first..last] {
                let from_left =
                    right == last || left < middle && keys[order[left] as usize] <= keys[order[right] as usize];
                let taken = if from_left { &mut left } else { &mut right };
                *place = order[*taken];
                *taken += 1;
            }
        }
        std::mem::swap(&mut order, &mut merged);
        run *= 2;
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_that_of_a_stable_sort() {
        for count in 0..70 {
            let keys: Vec<f64> = (0..count).map(|k| f64::from(k * k * 7919 % 23) - 11.0).collect();
            let mut expected: Vec<u32> = (0..count as u32).collect();
            expected.sort_by(|&a, &b| keys[a as usize].total_cmp(&keys[b as usize]));
            assert_eq!(ascending(&keys), expected);
        }
    }
}
