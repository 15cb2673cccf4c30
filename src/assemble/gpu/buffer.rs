use super::device::Gpu;
use bytemuck::{NoUninit, cast_slice};
use std::cell::Cell;
use std::ops::Deref;
use std::rc::Rc;
use wgpu::BufferUsages;

/// A buffer on the card, given back when it is dropped: a browser would wait for its garbage collector.
pub(super) struct Buffer {
    buffer: wgpu::Buffer,
    /// Of those that there are.
    count: Rc<Cell<usize>>,
}

impl Drop for Buffer {
    fn drop(&mut self) {
        self.buffer.destroy();
        self.count.set(self.count.get() - 1);
    }
}

impl Deref for Buffer {
    type Target = wgpu::Buffer;

    fn deref(&self) -> &wgpu::Buffer {
        &self.buffer
    }
}

impl Buffer {
    /// Of zeros.
    pub fn empty(gpu: &Gpu, usage: BufferUsages, bytes: usize) -> Self {
        // No buffer may be empty, and uniforms come in sixteens.
        let size = bytes.max(16).next_multiple_of(16) as u64;
        let descriptor = wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
        let count = gpu.buffer_count().clone();
        count.set(count.get() + 1);
        Self { buffer: gpu.device.create_buffer(&descriptor), count }
    }

    pub fn filled<T: NoUninit>(gpu: &Gpu, usage: BufferUsages, numbers: &[T]) -> Self {
        let buffer = Self::empty(gpu, usage | BufferUsages::COPY_DST, size_of_val(numbers));
        gpu.queue.write_buffer(&buffer, 0, cast_slice(numbers));
        buffer
    }
}
