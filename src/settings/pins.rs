//! Points that the user ties together.

use crate::energy::Pin;
use crate::error::Error;
use crate::words::number;

/// More are a shape of their own, and each costs a search in every evaluation.
pub const MOST_PINS: usize = 1000;

impl<const D: usize> Pin<D> {
    /// Reads D numbers on the reference's side and D on the template's, pin by pin.
    ///
    /// # Errors
    /// Names the first number that makes no pin.
    pub fn read(numbers: &[f64]) -> Result<Vec<Self>, Error> {
        let refuse = |value: String, range: String| Err(Error::Setting { name: "pins", value, range });
        let size = 2 * D;
        if !numbers.len().is_multiple_of(size) {
            let range = format!("a multiple of {size}: {D} numbers on the reference's side and {D} on the template's");
            return refuse(format!("{} numbers long", numbers.len()), range);
        }
        if numbers.len() > size * MOST_PINS {
            return refuse(format!("a list of {} pins", numbers.len() / size), format!("at most {MOST_PINS}"));
        }
        if let Some(at) = numbers.iter().position(|x| !(0.0..=1.0).contains(x)) {
            let side = if at % size < D { "reference" } else { "template" };
            let axis = ["x", "y", "z"][at % D];
            let place = format!("pin {}, {axis} on the {side}'s side", at / size);
            return refuse(
                format!("{} at position {at} ({place})", number(numbers[at])),
                "from 0 to 1, within the box".into(),
            );
        }
        let point = |part: &[f64]| std::array::from_fn(|k| part[k]);
        Ok(numbers
            .chunks_exact(size)
            .map(|pin| Self { reference: point(&pin[..D]), template: point(&pin[D..]) })
            .collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_become_pins_of_either_dimension() {
        let numbers = [0.1, 0.2, 0.3, 0.4, 0.5, 1.0, 0.0, 0.8, 0.9, 0.1, 0.2, 0.3];
        let [first, second, third] = Pin::<2>::read(&numbers).unwrap()[..] else { panic!("three pins") };
        assert_eq!((first.reference, first.template), ([0.1, 0.2], [0.3, 0.4]));
        assert_eq!((second.reference, third.template), ([0.5, 1.0], [0.2, 0.3]));
        assert_eq!(Pin::<3>::read(&numbers).unwrap()[1].template, [0.1, 0.2, 0.3]);
        assert_eq!(Pin::<2>::read(&[]), Ok(vec![]));
    }

    #[test]
    fn what_makes_no_pin_is_refused_with_its_place() {
        let says = |numbers: &[f64], part: &str| {
            let message = Pin::<2>::read(numbers).unwrap_err().to_string();
            assert!(message.starts_with("pins is ") && message.contains(part), "{message}");
        };
        says(&[0.5; 6], "6 numbers long, but must be a multiple of 4");
        says(&[0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, f64::NAN], "NaN at position 7 (pin 1, y on the template's side)");
        says(&[0.5, 1.5, 0.5, 0.5], "1.5 at position 1 (pin 0, y on the reference's side)");
        says(&[0.5; 4 * (MOST_PINS + 1)], "a list of 1001 pins, but must be at most 1000");
    }
}
