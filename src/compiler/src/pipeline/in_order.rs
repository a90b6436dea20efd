//! Work that has to be done in order, by whichever thread has time.

use std::collections::VecDeque;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Steps that change one state, one after the other.
pub(super) struct InOrder<S, T> {
    /// Held by whoever takes steps from those that wait, so that they are taken in order.
    state: Mutex<S>,
    waiting: Mutex<VecDeque<T>>,
    step: fn(&mut S, T),
}

/// What a panic leaves behind is whole, steps are moved and not changed; or nobody relies on it, for what follows is not read.
pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl<S, T> InOrder<S, T> {
    /// Without steps as yet.
    pub(super) fn new(state: S, step: fn(&mut S, T)) -> Self {
        Self { state: Mutex::new(state), waiting: Mutex::default(), step }
    }

    /// Puts a step behind those that wait. Yields how many wait now. Whoever takes steps meanwhile takes this one, too, or the next one who
    /// looks does.
    pub(super) fn push(&self, step: T) -> usize {
        let mut waiting = lock(&self.waiting);
        waiting.push_back(step);
        waiting.len()
    }

    /// Takes all steps that wait, unless another thread does.
    pub(super) fn help(&self) {
        if let Ok(state) = self.state.try_lock() {
            drop(self.work(state));
        }
    }

    /// The state when all steps are taken.
    pub(super) fn settled(&self) -> MutexGuard<'_, S> {
        self.work(lock(&self.state))
    }

    fn work<'a>(&self, mut state: MutexGuard<'a, S>) -> MutexGuard<'a, S> {
        loop {
            let next = lock(&self.waiting).pop_front();
            let Some(next) = next else { return state };
            (self.step)(&mut state, next);
        }
    }
}
