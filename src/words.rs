//! How messages show what they were given.

/// Characters of a quotation; the rest is left out.
const LONGEST: usize = 60;

/// In quotation marks, shortened to what a line can hold.
pub fn quoted(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        None => format!("\"{text}\""),
        Some((end, _)) => format!("\"{}…\"", &text[..end]),
    }
}

/// With an exponent where zeros would have to be counted.
pub fn number(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) || !value.is_finite() {
        value.to_string()
    } else {
        format!("{value:e}")
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
        let shown = [0.0, -1.5, 1e308, 1e-14, 1e6, 129.0, f64::NAN, f64::INFINITY].map(number);
        assert_eq!(shown, ["0", "-1.5", "1e308", "1e-14", "1e6", "129", "NaN", "inf"]);
    }

    #[test]
    fn edits_count_typing_errors() {
        assert_eq!(edits("bendign", "bending"), 1);
        assert_eq!(edits("Bending", "bending"), 0);
        assert_eq!(edits("memmbrane", "membrane"), 1);
        assert_eq!(edits("sigma", "mu"), 4);
    }
}
