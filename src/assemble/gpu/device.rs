use super::kernels::Kernels;
use super::pace::Pace;
use std::cell::{Cell, OnceCell, RefCell};
use std::collections::BTreeMap;
use std::future::poll_fn;
use std::mem::ManuallyDrop;
use std::rc::Rc;
use std::sync::{Arc, Mutex};
use std::task::{Poll, Waker};

/// A graphics card, and the kernels compiled for it.
pub struct Gpu {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    name: String,
    is_software: bool,
    /// By dimension and cells a side.
    paces: RefCell<BTreeMap<(usize, usize), Pace>>,
    counts: Cell<Counts>,
    buffers: Rc<Cell<usize>>,
    trouble: Arc<Mutex<Option<String>>>,
    kernels: [OnceCell<Rc<Kernels>>; 2],
}

/// What has gone to and fro.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Counts {
    /// Answers that were waited for, and their bytes.
    pub readbacks: usize,
    pub bytes_read: u64,
    pub dispatches: usize,
}

impl Counts {
    /// What has come since.
    pub fn since(self, before: Self) -> Self {
        Self {
            readbacks: self.readbacks - before.readbacks,
            bytes_read: self.bytes_read - before.bytes_read,
            dispatches: self.dispatches - before.dispatches,
        }
    }
}

thread_local! {
    /// The card of this thread, and the kernels compiled for it: registrations share them. Not given back when the thread
    /// ends, for what that takes of the thread may have ended before.
    static SHARED: RefCell<Option<ManuallyDrop<Rc<Gpu>>>> = const { RefCell::new(None) };
}

impl Gpu {
    /// The card that all registrations share; a new device where the last one was lost.
    ///
    /// # Errors
    /// A sentence, if there is no card or it refuses.
    pub async fn shared() -> Result<Rc<Self>, String> {
        let kept = || {
            let gpu = SHARED.with_borrow(|shared| shared.as_deref().cloned());
            gpu.filter(|gpu| gpu.trouble().is_none())
        };
        if let Some(gpu) = kept() {
            return Ok(gpu);
        }
        let gpu = Self::open().await?;
        // Who asked at the same time may have been first.
        if let Some(first) = kept() {
            gpu.destroy();
            return Ok(first);
        }
        drop(SHARED.replace(Some(ManuallyDrop::new(gpu.clone()))).map(ManuallyDrop::into_inner));
        Ok(gpu)
    }

    /// With the limits that every device has, which are enough: what is large is written in slabs.
    ///
    /// # Errors
    /// A sentence, if there is no card or it refuses.
    pub async fn open() -> Result<Rc<Self>, String> {
        Self::open_within(wgpu::Limits::default()).await
    }

    /// # Errors
    /// A sentence, if there is no card with these limits or it refuses.
    pub async fn open_within(required_limits: wgpu::Limits) -> Result<Rc<Self>, String> {
        #[cfg(target_arch = "wasm32")]
        let told = super::browser::ask().await?;
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        };
        let adapter = instance
            .request_adapter(&options)
            .await
            .map_err(|error| format!("there is no graphics card to compute on ({})", said(&error)))?;
        #[cfg(not(target_arch = "wasm32"))]
        let (name, is_software) = {
            let info = adapter.get_info();
            (info.name, info.device_type == wgpu::DeviceType::Cpu)
        };
        #[cfg(target_arch = "wasm32")]
        let (name, is_software) = (told.name, told.is_software);
        let descriptor = wgpu::DeviceDescriptor { required_limits, ..Default::default() };
        let (device, queue) = adapter
            .request_device(&descriptor)
            .await
            .map_err(|error| format!("the graphics card refuses to compute ({})", said(&error)))?;

        let trouble = Arc::new(Mutex::new(None));
        let (lost, failed) = (trouble.clone(), trouble.clone());
        device.set_device_lost_callback(move |_, message| {
            note(&lost, format!("the graphics device was lost ({message})"));
        });
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            note(&failed, format!("the graphics device failed ({error})"));
        }));
        Ok(Rc::new(Self {
            device,
            queue,
            name,
            is_software,
            paces: RefCell::default(),
            counts: Cell::default(),
            buffers: Rc::default(),
            trouble,
            kernels: Default::default(),
        }))
    }

    /// The adapter's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether a processor plays the card.
    pub fn is_software(&self) -> bool {
        self.is_software
    }

    /// What is known of grids with so many cells a side.
    pub fn pace<const D: usize>(&self, cells: usize) -> Option<Pace> {
        self.paces.borrow().get(&(D, cells)).copied()
    }

    pub(super) fn keep_pace<const D: usize>(&self, cells: usize, pace: Pace) {
        self.paces.borrow_mut().insert((D, cells), pace);
    }

    /// Since the card was opened.
    pub fn counts(&self) -> Counts {
        self.counts.get()
    }

    pub(super) fn count(&self, add: impl FnOnce(&mut Counts)) {
        let mut counts = self.counts.get();
        add(&mut counts);
        self.counts.set(counts);
    }

    /// How many buffers there are on the card now.
    pub fn buffers(&self) -> usize {
        self.buffers.get()
    }

    pub(super) fn buffer_count(&self) -> &Rc<Cell<usize>> {
        &self.buffers
    }

    /// Why nothing can be computed any more.
    pub fn trouble(&self) -> Option<String> {
        self.trouble.lock().map_or_else(|poisoned| poisoned.into_inner().clone(), |trouble| trouble.clone())
    }

    /// Gives the device up, as a driver may at any time.
    pub fn destroy(&self) {
        self.device.destroy();
        note(&self.trouble, "the graphics device was given up".to_owned());
    }

    pub(super) fn kernels<const D: usize>(&self) -> Rc<Kernels> {
        self.kernels[D - 2].get_or_init(|| Rc::new(Kernels::new::<D>(&self.device))).clone()
    }

    /// The bytes of a buffer's beginning, once all that was submitted is done; None if the device fails.
    pub(super) async fn read<T>(&self, buffer: &wgpu::Buffer, bytes: u64, take: impl FnOnce(&[u8]) -> T) -> Option<T> {
        let answer = Arc::new(Mutex::new(Answer::default()));
        let given = answer.clone();
        self.count(|counts| {
            counts.readbacks += 1;
            counts.bytes_read += bytes;
        });
        buffer.map_async(wgpu::MapMode::Read, 0..bytes, move |result| give(&given, result.is_ok()));
        #[cfg(not(target_arch = "wasm32"))]
        self.device.poll(wgpu::PollType::wait_indefinitely()).ok()?;
        let mapped = poll_fn(|context| match answer.lock() {
            Err(_) => Poll::Ready(false),
            Ok(mut answer) => answer.mapped.map_or_else(
                || {
                    answer.waker = Some(context.waker().clone());
                    Poll::Pending
                },
                Poll::Ready,
            ),
        })
        .await;
        if !mapped {
            note(&self.trouble, "the graphics device gives no answer".to_owned());
            return None;
        }
        let taken = buffer.get_mapped_range(0..bytes).ok().map(|view| take(&view));
        buffer.unmap();
        taken.filter(|_| self.trouble().is_none())
    }
}

/// Whether a buffer could be mapped, and who waits to hear it.
#[derive(Default)]
struct Answer {
    mapped: Option<bool>,
    waker: Option<Waker>,
}

fn give(answer: &Mutex<Answer>, mapped: bool) {
    let waker = answer.lock().ok().and_then(|mut answer| {
        answer.mapped = Some(mapped);
        answer.waker.take()
    });
    if let Some(waker) = waker {
        waker.wake();
    }
}

/// What an error says. A browser's comes with where in its code it arose, line by line.
fn said(error: &impl ToString) -> String {
    let text = error.to_string();
    let line = text.lines().next().unwrap_or_default();
    line.strip_prefix("JsValue(").map_or(line, |value| value.strip_suffix(')').unwrap_or(value)).to_owned()
}

/// The first reason is the one to tell.
fn note(trouble: &Mutex<Option<String>>, reason: String) {
    if let Ok(mut trouble) = trouble.lock() {
        trouble.get_or_insert(reason);
    }
}

#[cfg(test)]
mod tests {
    use super::said;

    #[test]
    fn of_a_browsers_error_only_what_it_says_is_told() {
        let browsers =
            "JsValue(TypeError: no device\nTypeError: no device\n    at requestDevice (thinshell.js:763:30))";
        assert_eq!(said(&browsers), "TypeError: no device");
        assert_eq!(said(&"JsValue(OperationError: lost)"), "OperationError: lost");
        assert_eq!(said(&"limits (of 2) are not met"), "limits (of 2) are not met");
    }
}
