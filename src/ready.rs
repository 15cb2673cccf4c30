//! Futures that never wait.

use std::pin::pin;
use std::task::{Context, Poll, Waker};

/// The value of a future that is ready at once, as all computations on the CPU are.
///
/// # Panics
/// If the future waits for something.
pub fn ready<F: Future>(future: F) -> F::Output {
    match pin!(future).poll(&mut Context::from_waker(Waker::noop())) {
        Poll::Ready(value) => value,
        Poll::Pending => panic!("a computation on the CPU waited for something"),
    }
}
