//! What several test files share.
#![allow(dead_code, reason = "each test file is a crate of its own and uses a part")]

use std::pin::pin;
use std::task::{Context, Poll, Waker};

/// The value of a future that never waits, as all of the CPU's are.
pub fn ready<F: Future>(future: F) -> F::Output {
    match pin!(future).poll(&mut Context::from_waker(Waker::noop())) {
        Poll::Ready(value) => value,
        Poll::Pending => panic!("a CPU computation waited for something"),
    }
}
