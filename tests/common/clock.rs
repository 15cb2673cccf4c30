//! What computing takes, where others compute beside it.

/// Processor time of this process, or the clock's where the system does not tell: others on the machine do not count.
pub fn seconds() -> f64 {
    const TICKS_A_SECOND: f64 = 100.0;
    let clock = || std::time::SystemTime::UNIX_EPOCH.elapsed().map_or(0.0, |since| since.as_secs_f64());
    let Ok(stat) = std::fs::read_to_string("/proc/self/stat") else { return clock() };
    // The name before the last bracket may hold anything.
    let numbers: Vec<f64> =
        stat.rsplit(')').next().unwrap_or("").split_whitespace().filter_map(|word| word.parse().ok()).collect();
    // The state, a letter, is left out.
    numbers.get(10..12).map_or_else(clock, |times| times.iter().sum::<f64>() / TICKS_A_SECOND)
}
