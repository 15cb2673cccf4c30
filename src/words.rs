//! How messages show what they were given.

/// Characters of a quotation; the rest is left out.
const LONGEST: usize = 60;

/// In quotation marks, shortened to what a line can hold.
pub fn quoted(text: &str) -> String {
    let shortened: String = text.chars().take(LONGEST).collect();
    let rest = if shortened.len() < text.len() { "…" } else { "" };
    format!("\"{shortened}{rest}\"")
}

// Formatting a double by the standard library takes twenty-five kilobytes of module: it knows the shortest decimal of
// each. Fourteen digits are safe from the rounding of powers of ten, and take whole numbers only. A double in a message or
// an assertion, or `clamp` with bounds that are no constants, would bring it all back.

/// With the digits that there are, fourteen at most; with an exponent where zeros would have to be counted.
pub fn number(value: f64) -> String {
    let size = value.abs();
    let Some((mut digits, mut power)) = leading(size, 14) else { return special(value) };
    while digits.is_multiple_of(10) {
        (digits, power) = (digits / 10, power + 1);
    }
    let words = if !(1e-3..1e6).contains(&size) {
        let behind = digits.ilog10();
        format!("{}e{}", pointed(digits, behind), power + behind as i32)
    } else if power < 0 {
        pointed(digits, power.unsigned_abs())
    } else {
        (digits * 10_u64.pow(power.unsigned_abs())).to_string()
    };
    signed(value, words)
}

/// With so many digits behind the point.
pub fn fixed(value: f64, decimals: u32) -> String {
    let scaled = (value.abs() * 10_f64.powi(decimals as i32)).round_ties_even();
    if scaled >= 1e15 || !value.is_finite() {
        return number(value);
    }
    let words = pointed(scaled as u64, decimals);
    if scaled == 0.0 { words } else { signed(value, words) }
}

/// With four digits and an exponent.
pub fn scientific(value: f64) -> String {
    let Some((digits, power)) = leading(value.abs(), 4) else { return special(value) };
    signed(value, format!("{}e{}", pointed(digits, 3), power + 3))
}

fn signed(value: f64, words: String) -> String {
    if value < 0.0 { format!("-{words}") } else { words }
}

/// What has no leading digit.
fn special(value: f64) -> String {
    let words = if value.is_nan() {
        "NaN"
    } else if value == 0.0 {
        "0"
    } else {
        "inf"
    };
    signed(value, words.into())
}

/// The number of tenths, hundredths and so on.
fn pointed(digits: u64, decimals: u32) -> String {
    let unit = 10_u64.pow(decimals);
    let (whole, rest) = (digits / unit, digits % unit);
    if decimals == 0 { whole.to_string() } else { format!("{whole}.{rest:0width$}", width = decimals as usize) }
}

/// The leading decimal digits of a positive number, and the power of ten that they count.
fn leading(value: f64, count: u32) -> Option<(u64, i32)> {
    if value == 0.0 || !value.is_finite() {
        return None;
    }
    // The binary exponent tells the decimal one but for a step or, of the smallest numbers, a few.
    let binary = (value.to_bits() >> 52) as i32 - 1023;
    let mut power = (f64::from(binary) * std::f64::consts::LOG10_2) as i32 - count as i32;
    loop {
        // In two factors, since 10³²³ is no number.
        let half = power / 2;
        let digits = (value * 10_f64.powi(-half) * 10_f64.powi(half - power)).round_ties_even() as u64;
        if digits >= 10_u64.pow(count) {
            power += 1;
        } else if digits < 10_u64.pow(count - 1) {
            power -= 1;
        } else {
            return Some((digits, power));
        }
    }
}

/// Insertions, deletions, replacements and swaps of neighbours that make the one word into the other, capitals aside.
pub fn edits(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|word| word.to_ascii_lowercase().chars().collect::<Vec<_>>());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1)
            };
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                rows[i][j] = rows[i][j].min(rows[i - 2][j - 2] + 1);
            }
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quotation_is_cut_between_characters() {
        assert_eq!(quoted("round"), "\"round\"");
        assert_eq!(quoted(&"ä".repeat(60)), format!("\"{}\"", "ä".repeat(60)));
        assert_eq!(quoted(&"ä".repeat(100_000)), format!("\"{}…\"", "ä".repeat(60)));
    }

    #[test]
    fn no_number_is_longer_than_its_digits() {
        let shown = [0.0, -1.5, 1e308, 1e-14, 1e6, 129.0, 0.1 + 0.2, -1e-300, 5e-324].map(number);
        assert_eq!(shown, ["0", "-1.5", "1e308", "1e-14", "1e6", "129", "0.3", "-1e-300", "4.9406564584125e-324"]);
        assert_eq!([f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(number), ["NaN", "inf", "-inf"]);
    }

    #[test]
    fn numbers_are_those_of_the_standard_library() {
        let mut value = 1.234_567_890_123_456_7e-20_f64;
        for _ in 0..300 {
            value *= -1.467;
            assert_eq!(fixed(value.abs() % 1e5, 3), format!("{:.3}", value.abs() % 1e5));
            assert_eq!(scientific(value), format!("{value:.3e}"));
            assert!((number(value).parse::<f64>().unwrap() / value - 1.0).abs() < 1e-13, "{value}");
        }
    }

    #[test]
    fn digits_behind_the_point_are_rounded_and_nothing_is_negative_zero() {
        assert_eq!([0.996, -0.04, 12.0, 1e20].map(|value| fixed(value, 1)), ["1.0", "0.0", "12.0", "1e20"]);
        assert_eq!([0.5, 99.6].map(|value| fixed(value, 0)), ["0", "100"]);
        assert_eq!([9.9996, 0.0, f64::INFINITY].map(scientific), ["1.000e1", "0", "inf"]);
    }

    #[test]
    fn edits_count_typing_errors() {
        assert_eq!(edits("bendign", "bending"), 1);
        assert_eq!(edits("Bending", "bending"), 0);
        assert_eq!(edits("memmbrane", "membrane"), 1);
        assert_eq!(edits("sigma", "mu"), 4);
    }
}
