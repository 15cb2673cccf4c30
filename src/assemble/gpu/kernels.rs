use super::device::Gpu;
use crate::assemble::shaders::source;
use crate::energy::{GRADIENT, HESSIAN, VALUE};
use std::cell::OnceCell;

/// Invocations of a workgroup.
pub(super) const GROUP: usize = 64;

/// Bindings, numbered as in `shaders/level.wgsl`.
pub(super) mod binding {
    pub const LEVEL: u32 = 0;
    pub const SLAB: u32 = 1;
    pub const NODES: u32 = 2;
    pub const VOLUME_WEIGHTS: u32 = 3;
    pub const TEMPLATE: u32 = 4;
    pub const BAND: u32 = 5;
    pub const SAMPLES: u32 = 6;
    pub const FORCES: u32 = 7;
    pub const ROWS: u32 = 8;
    pub const GRADIENT: u32 = 9;
    pub const RESULTS: u32 = 10;
    pub const PAIRS: u32 = 11;
    pub const BLOCKS: u32 = 12;
    // As in `shaders/multigrid.wgsl`, `gradients.wgsl`, `resident.wgsl` and `pins.wgsl`.
    pub const PLACE: u32 = 13;
    pub const NEAR: u32 = 14;
    pub const FAR: u32 = 15;
    pub const INVERSE: u32 = 16;
    pub const RIGHT: u32 = 17;
    pub const SOLUTION: u32 = 18;
    pub const RESIDUAL: u32 = 19;
    pub const SCALARS: u32 = 20;
    pub const SEARCH: u32 = 21;
    pub const DIRECTION: u32 = 22;
    pub const PARTIALS: u32 = 23;
    pub const COORDINATES: u32 = 24;
    pub const TRIAL: u32 = 25;
    pub const PLACED: u32 = 26;
    pub const PINS: u32 = 27;
    pub const TIES: u32 = 28;
    pub const KNOTS: u32 = 29;
}
use binding as b;

/// An entry point, and what it is given: no more than eight arrays, which every device has.
pub(super) struct Kernel {
    pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
    bindings: &'static [u32],
}

/// The entry points that assemble; those of cells by order of differentiation, the value or the gradient.
pub(super) struct Kernels {
    module: wgpu::ShaderModule,
    solver: OnceCell<Solver>,
    pub volume: [Kernel; 2],
    pub shell: [Kernel; 2],
    pub gather_gradient: Kernel,
    pub reduce: Kernel,
    pub volume_pairs: Kernel,
    pub shell_pairs: Kernel,
    pub gather_blocks: Kernel,
}

impl Kernels {
    pub fn new<const D: usize>(device: &wgpu::Device) -> Self {
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(source::<D>().into()),
        });
        let kernel = |entry, order, bindings| Kernel::new(device, &module, entry, order, bindings);
        let volume = |order| {
            kernel("volume_cells", order, &[b::LEVEL, b::SLAB, b::NODES, b::VOLUME_WEIGHTS, b::FORCES, b::ROWS])
        };
        let shell = |order| {
            let arrays = &[b::LEVEL, b::SLAB, b::NODES, b::TEMPLATE, b::BAND, b::SAMPLES, b::FORCES, b::ROWS];
            kernel("shell_cells", order, arrays)
        };
        Self {
            solver: OnceCell::new(),
            volume: [VALUE, GRADIENT].map(volume),
            shell: [VALUE, GRADIENT].map(shell),
            gather_gradient: kernel("gather_gradient", GRADIENT, &[b::LEVEL, b::SLAB, b::FORCES, b::GRADIENT]),
            reduce: kernel("reduce", VALUE, &[b::ROWS, b::RESULTS]),
            volume_pairs: kernel("volume_pairs", HESSIAN, &[b::LEVEL, b::SLAB, b::NODES, b::VOLUME_WEIGHTS, b::PAIRS]),
            shell_pairs: kernel(
                "shell_pairs",
                HESSIAN,
                &[b::LEVEL, b::SLAB, b::NODES, b::TEMPLATE, b::BAND, b::SAMPLES, b::PAIRS],
            ),
            gather_blocks: kernel("gather_blocks", HESSIAN, &[b::LEVEL, b::SLAB, b::PAIRS, b::BLOCKS]),
            module,
        }
    }

    /// Those of a step of Newton's method, compiled when the first is to be made.
    pub fn solver(&self, gpu: &Gpu) -> &Solver {
        self.solver.get_or_init(|| Solver::new(&gpu.device, &self.module))
    }
}

/// The entry points that solve for a direction and follow it.
pub(super) struct Solver {
    pub sweep: Kernel,
    pub leave_residual: Kernel,
    pub restrict: Kernel,
    pub prolongate: Kernel,
    pub small_cycle: Kernel,
    pub coarsen: Kernel,
    pub invert_diagonal: Kernel,
    pub begin: Kernel,
    pub begun: Kernel,
    pub overlap: Kernel,
    pub choose_turn: Kernel,
    pub turn: Kernel,
    pub apply: Kernel,
    pub choose_step: Kernel,
    pub advance: Kernel,
    pub judge: Kernel,
    pub fall: Kernel,
    pub fallen: Kernel,
    pub place_nodes: Kernel,
    pub move_nodes: Kernel,
    pub gather_stencil: Kernel,
    pub weigh: Kernel,
    pub weighed: Kernel,
    pub stiffen: Kernel,
    /// The value and the gradient.
    pub pull_pins: [Kernel; 2],
    pub stiffen_pins: Kernel,
}

/// What ends a sum: the parts, and where it goes.
const SUM: &[u32] = &[b::PLACE, b::PARTIALS, b::SCALARS];

impl Solver {
    fn new(device: &wgpu::Device, module: &wgpu::ShaderModule) -> Self {
        let kernel = |entry, bindings| Kernel::new(device, module, entry, VALUE, bindings);
        let relaxed = &[b::PLACE, b::NEAR, b::FAR, b::INVERSE, b::RIGHT, b::SOLUTION, b::SCALARS];
        let rest = &[b::PLACE, b::NEAR, b::FAR, b::RIGHT, b::SOLUTION, b::RESIDUAL, b::SCALARS];
        let cycle = &[b::PLACE, b::NEAR, b::FAR, b::INVERSE, b::RIGHT, b::SOLUTION, b::RESIDUAL];
        let image = &[b::PLACE, b::NEAR, b::FAR, b::SOLUTION, b::RESIDUAL, b::SCALARS, b::PARTIALS];
        let step = &[b::PLACE, b::DIRECTION, b::SEARCH, b::RIGHT, b::RESIDUAL, b::SCALARS, b::PARTIALS];
        let pulled = &[b::LEVEL, b::NODES, b::GRADIENT, b::RESULTS, b::PINS, b::TIES];
        let start = &[b::PLACE, b::GRADIENT, b::RIGHT, b::DIRECTION, b::SOLUTION, b::PARTIALS];
        Self {
            sweep: kernel("sweep", relaxed),
            leave_residual: kernel("leave_residual", rest),
            restrict: kernel("restrict_residual", &[b::PLACE, b::RIGHT, b::SOLUTION, b::RESIDUAL, b::SCALARS]),
            prolongate: kernel("prolongate", &[b::PLACE, b::SOLUTION, b::SCALARS]),
            small_cycle: kernel("small_cycle", cycle),
            coarsen: kernel("coarsen", &[b::PLACE, b::NEAR, b::FAR]),
            invert_diagonal: kernel("invert_diagonal", &[b::PLACE, b::NEAR, b::FAR, b::INVERSE]),
            begin: kernel("begin", start),
            begun: kernel("begun", SUM),
            overlap: kernel("overlap", &[b::PLACE, b::RIGHT, b::SOLUTION, b::PARTIALS]),
            choose_turn: kernel("choose_turn", SUM),
            turn: kernel("turn", &[b::PLACE, b::SOLUTION, b::SEARCH, b::SCALARS]),
            apply: kernel("apply", image),
            choose_step: kernel("choose_step", SUM),
            advance: kernel("advance", step),
            judge: kernel("judge", SUM),
            fall: kernel("fall", &[b::PLACE, b::GRADIENT, b::DIRECTION, b::PARTIALS]),
            fallen: kernel("fallen", SUM),
            place_nodes: kernel("place_nodes", &[b::LEVEL, b::DIRECTION, b::COORDINATES, b::TRIAL, b::PLACED]),
            move_nodes: kernel("move_nodes", &[b::LEVEL, b::DIRECTION, b::COORDINATES, b::TRIAL]),
            gather_stencil: kernel("gather_stencil", &[b::LEVEL, b::SLAB, b::PAIRS, b::PLACE, b::NEAR, b::FAR]),
            weigh: kernel("weigh", &[b::PLACE, b::NEAR, b::FAR, b::PARTIALS]),
            weighed: kernel("weighed", SUM),
            stiffen: kernel("stiffen", &[b::PLACE, b::NEAR, b::FAR, b::SCALARS]),
            pull_pins: [VALUE, GRADIENT].map(|order| Kernel::new(device, module, "pull_pins", order, pulled)),
            stiffen_pins: kernel("stiffen_pins", &[b::PLACE, b::NEAR, b::FAR, b::KNOTS]),
        }
    }
}

impl Kernel {
    fn new(
        device: &wgpu::Device,
        module: &wgpu::ShaderModule,
        entry: &str,
        order: u8,
        bindings: &'static [u32],
    ) -> Self {
        let entries: Vec<_> = bindings.iter().map(|&binding| layout_of(binding)).collect();
        let layout =
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(entry), entries: &entries });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(entry),
            bind_group_layouts: &[Some(&layout)],
            ..Default::default()
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(entry),
            layout: Some(&pipeline_layout),
            module,
            entry_point: Some(entry),
            compilation_options: wgpu::PipelineCompilationOptions {
                constants: &[("ORDER", f64::from(order))],
                ..Default::default()
            },
            cache: None,
        });
        Self { pipeline, layout, bindings }
    }

    /// So many invocations, in whole workgroups; none need be none.
    pub fn dispatch(&self, gpu: &Gpu, pass: &mut wgpu::ComputePass<'_>, buffers: &wgpu::BindGroup, invocations: usize) {
        if invocations > 0 {
            gpu.count(|counts| counts.dispatches += 1);
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, buffers, &[]);
            pass.dispatch_workgroups(invocations.div_ceil(GROUP) as u32, 1, 1);
        }
    }

    /// The bind group of the buffers that it is given.
    pub fn bind<'a>(&self, device: &wgpu::Device, buffer: impl Fn(u32) -> &'a wgpu::Buffer) -> wgpu::BindGroup {
        let entries: Vec<_> = self
            .bindings
            .iter()
            .map(|&binding| wgpu::BindGroupEntry { binding, resource: buffer(binding).as_entire_binding() })
            .collect();
        device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout: &self.layout, entries: &entries })
    }
}

fn layout_of(binding: u32) -> wgpu::BindGroupLayoutEntry {
    let ty = match binding {
        b::LEVEL | b::SLAB | b::PLACE | b::TRIAL => wgpu::BufferBindingType::Uniform,
        b::NODES..=b::SAMPLES | b::PINS..=b::KNOTS => wgpu::BufferBindingType::Storage { read_only: true },
        _ => wgpu::BufferBindingType::Storage { read_only: false },
    };
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
        count: None,
    }
}
