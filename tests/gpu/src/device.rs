//! One Vulkan device, and compute shaders run on it.

use bluedither::shader::Table;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{BindGroupLayoutEntry, BindingType, BufferBindingType, BufferUsages, ShaderStages};

/// Where a shader finds its arguments and leaves its results, beside the tables in group 0.
pub const GIVEN: u32 = 20;
pub const FOUND: u32 = 21;

/// How a buffer is bound.
pub const READ: BufferBindingType = BufferBindingType::Storage { read_only: true };
pub const WRITE: BufferBindingType = BufferBindingType::Storage { read_only: false };
pub const UNIFORM: BufferBindingType = BufferBindingType::Uniform;

/// A table as it is bound: its words, and how large a texture of it is.
#[derive(Clone)]
pub struct Bound {
    pub table: Table,
    pub size: String,
    pub words: Vec<u32>,
    pub extent: [usize; 2],
}

/// How tables are bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    Storage,
    Texture,
}

impl Bound {
    /// The text that reads it.
    pub fn text(&self, way: Way) -> String {
        let text = if way == Way::Storage { self.table.storage } else { self.table.texture };
        format!("{}{text}", self.size)
    }

    fn layout(&self, way: Way) -> BindGroupLayoutEntry {
        let ty = match way {
            Way::Storage => buffer(READ),
            Way::Texture => BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Uint,
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
        };
        entry(self.table.binding, ty)
    }
}

pub struct Device {
    device: wgpu::Device,
    queue: wgpu::Queue,
    pub name: String,
}

impl Device {
    /// The error is one line with the cure.
    pub fn new() -> Result<Self, String> {
        let missing = "there is no Vulkan device: one in software is installed by \
                       `apt-get install mesa-vulkan-drivers libvulkan1`";
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::VULKAN;
        let instance = wgpu::Instance::new(descriptor);
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()));
        let adapter = adapter.map_err(|_| missing.to_string())?;
        let opened = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()));
        let (device, queue) =
            opened.map_err(|error| format!("the Vulkan device cannot be opened ({error}): {missing}"))?;
        Ok(Self { device, queue, name: adapter.get_info().name })
    }

    /// Entry point `main` of `text` on `groups` workgroups, with `given` and the tables bound: `results` words.
    pub fn run(
        &self,
        text: &str,
        tables: &[Bound],
        way: Way,
        given: &[u32],
        results: usize,
        groups: [u32; 2],
    ) -> Vec<u32> {
        let found = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: results as u64 * 4,
            usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        });
        let given = self.buffer(given);
        self.dispatch(text, tables, way, &[(GIVEN, &given, READ), (FOUND, &found, WRITE)], &["main"], groups);
        self.read(&found)
    }

    /// Entry points one after the other, with buffers of the caller's.
    pub fn dispatch(
        &self,
        text: &str,
        tables: &[Bound],
        way: Way,
        buffers: &[(u32, &wgpu::Buffer, BufferBindingType)],
        entries: &[&str],
        groups: [u32; 2],
    ) {
        let module = self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(text.into()),
        });
        let own = buffers.iter().map(|&(binding, _, ty)| entry(binding, buffer(ty)));
        let entries_of_layout: Vec<_> = tables.iter().map(|table| table.layout(way)).chain(own).collect();
        let layout = self
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries_of_layout });
        let held: Vec<Held> = tables.iter().map(|table| self.hold(table, way)).collect();
        let own = buffers
            .iter()
            .map(|&(binding, buffer, _)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() });
        let entries_of_group: Vec<_> =
            tables.iter().zip(&held).map(|(table, held)| held.entry(table.table.binding)).chain(own).collect();
        let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &layout,
            entries: &entries_of_group,
        });
        let pipelines = self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        for &entry in entries {
            let pipeline = self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: None,
                layout: Some(&pipelines),
                module: &module,
                entry_point: Some(entry),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            });
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.dispatch_workgroups(groups[0], groups[1], 1);
        }
        self.queue.submit([encoder.finish()]);
    }

    /// A buffer of words.
    pub fn buffer(&self, words: &[u32]) -> wgpu::Buffer {
        self.device.create_buffer_init(&BufferInitDescriptor {
            label: None,
            contents: bytemuck::cast_slice(words),
            usage: BufferUsages::STORAGE | BufferUsages::UNIFORM | BufferUsages::COPY_SRC,
        })
    }

    /// What a buffer holds.
    pub fn read(&self, buffer: &wgpu::Buffer) -> Vec<u32> {
        let copy = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: buffer.size(),
            usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, buffer.size());
        self.queue.submit([encoder.finish()]);
        copy.map_async(wgpu::MapMode::Read, .., |done| done.expect("the buffer is mapped"));
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the device answers");
        let bytes = copy.get_mapped_range(..).expect("it is mapped");
        bytemuck::cast_slice(&bytes).to_vec()
    }

    fn hold(&self, bound: &Bound, way: Way) -> Held {
        if way == Way::Storage {
            return Held::Buffer(self.buffer(&bound.words));
        }
        let [width, height] = bound.extent.map(|side| side as u32);
        let format = match bound.table.format {
            "r16uint" => wgpu::TextureFormat::R16Uint,
            "rg16uint" => wgpu::TextureFormat::Rg16Uint,
            "r8uint" => wgpu::TextureFormat::R8Uint,
            "rgba32uint" => wgpu::TextureFormat::Rgba32Uint,
            _ => wgpu::TextureFormat::R32Uint,
        };
        let descriptor = wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        };
        let order = wgpu::util::TextureDataOrder::LayerMajor;
        let texture =
            self.device.create_texture_with_data(&self.queue, &descriptor, order, bytemuck::cast_slice(&bound.words));
        Held::Texture(texture.create_view(&wgpu::TextureViewDescriptor::default()))
    }
}

enum Held {
    Buffer(wgpu::Buffer),
    Texture(wgpu::TextureView),
}

impl Held {
    fn entry(&self, binding: u32) -> wgpu::BindGroupEntry<'_> {
        let resource = match self {
            Self::Buffer(buffer) => buffer.as_entire_binding(),
            Self::Texture(view) => wgpu::BindingResource::TextureView(view),
        };
        wgpu::BindGroupEntry { binding, resource }
    }
}

const fn entry(binding: u32, ty: BindingType) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry { binding, visibility: ShaderStages::COMPUTE, ty, count: None }
}

const fn buffer(ty: BufferBindingType) -> BindingType {
    BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None }
}
