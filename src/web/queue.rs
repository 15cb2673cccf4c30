//! One at a time: what is asked while a step is under way waits for it, or is refused by a sentence.

use js_sys::Promise;
use std::cell::{Cell, RefCell};
use std::pin::Pin;
use std::rc::Rc;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, future_to_promise};

const BUSY: &str = "a step or an update is under way; await its promise before asking for anything else";
const FREED: &str = "this registration has been freed; create a new one";
const BROKEN: &str = "an earlier call broke down, so this registration cannot go on; create a new one";

/// In a box, and the work too: each kind of its own would bring all of the machinery of promises again.
type Answer<'a> = Pin<Box<dyn Future<Output = Result<JsValue, JsError>> + 'a>>;

/// Something that is worked on in turns.
pub(super) struct Queue<T>(Rc<Shared<T>>);

struct Shared<T> {
    /// Away while a turn is under way.
    state: RefCell<Option<Box<T>>>,
    /// Turns that have not ended.
    turns: Cell<usize>,
    closed: Cell<bool>,
    /// Ends with the last turn.
    last: RefCell<Promise>,
}

impl<T: 'static> Queue<T> {
    pub fn new(state: T) -> Self {
        Self(Rc::new(Shared {
            state: RefCell::new(Some(Box::new(state))),
            turns: Cell::new(0),
            closed: Cell::new(false),
            last: RefCell::new(Promise::resolve(&JsValue::UNDEFINED)),
        }))
    }

    /// Works on the state once all before are done.
    pub fn enqueue(&self, work: impl AsyncFnOnce(&mut T) -> Result<JsValue, JsError> + 'static) -> Promise {
        self.enqueue_boxed(Box::new(|state| Box::pin(work(state))))
    }

    fn enqueue_boxed(&self, work: Box<dyn FnOnce(&mut T) -> Answer<'_>>) -> Promise {
        if self.0.closed.get() {
            return promise(async { Err(JsError::new(FREED)) });
        }
        let shared = self.0.clone();
        let before = JsFuture::from(self.0.last.borrow().clone());
        shared.turns.set(shared.turns.get() + 1);
        let turn = promise(async move {
            // Whether the turn before was refused is its caller's business.
            let _ = before.await;
            let state = shared.state.take();
            let answer = match state {
                Some(mut state) => {
                    let answer = work(&mut state).await;
                    if !shared.closed.get() {
                        shared.state.replace(Some(state));
                    }
                    answer
                }
                None if shared.closed.get() => Err(JsError::new(FREED)),
                None => Err(JsError::new(BROKEN)),
            };
            shared.turns.set(shared.turns.get() - 1);
            answer
        });
        *self.0.last.borrow_mut() = turn.clone();
        turn
    }

    /// Works on the state between turns.
    pub fn now<R>(&self, work: impl FnOnce(&mut T) -> Result<R, JsError>) -> Result<R, JsError> {
        let problem = if self.0.closed.get() {
            FREED
        } else if self.0.turns.get() > 0 {
            BUSY
        } else if let Some(state) = self.0.state.borrow_mut().as_mut() {
            return work(state);
        } else {
            BROKEN
        };
        Err(JsError::new(problem))
    }

    /// Lets go of the state, after the turn under way.
    pub fn close(&self) {
        self.0.closed.set(true);
        self.0.state.take();
    }
}

/// A promise of what a future gives.
pub(super) fn promise(future: impl Future<Output = Result<JsValue, JsError>> + 'static) -> Promise {
    promise_boxed(Box::pin(future))
}

fn promise_boxed(future: Answer<'static>) -> Promise {
    future_to_promise(async { future.await.map_err(JsValue::from) })
}
