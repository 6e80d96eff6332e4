//! A full-screen pass that draws its random numbers by `Sampler`, written to a PNG: what a user of wgpu copies.
//!
//! ```text
//! cargo run -p gpu --example full_screen -- target/full_screen.png
//! ```
//!
//! A lamp above a floor, and a ball that keeps its light off: one sample of the lamp a pixel, as white noise on the
//! left half and by `Sampler` on the right. In a material of bevy the table stands in another group: replace `@group(0)
//! @binding(0)` in the text by the one you bind.
#![allow(clippy::cast_possible_truncation, reason = "sizes of a small picture")]

use bluedither::shader;
use std::process::ExitCode;
use wgpu::util::{BufferInitDescriptor, DeviceExt as _};

const SIZE: u32 = 512;
/// What the shader's `View` holds.
type View = [u32; 4];

const MINE: &str = "
struct View { size: u32, seed: u32, spp: u32, frame: u32 }
@group(1) @binding(0) var<uniform> view: View;

@vertex
fn corners(@builtin(vertex_index) k: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(f32(k & 1u) * 4.0 - 1.0, f32(k >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn color(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let at = vec2<u32>(position.xy);
    let blue = bd_sampler_pixel(bd_sampler_with_spp(view.seed, view.spp), at.x, at.y, view.frame);
    let white = bd_white_pixel(bd_white_with_spp(view.seed, view.spp), at.x, at.y, view.frame);
    var light = 0.0;
    for (var index = 0u; index < view.spp; index++) {
        if at.x < view.size / 2u {
            light += lit(position.xy, bd_white_draw2(white, 0u, index));
        } else {
            light += lit(position.xy, bd_sampler_draw2(blue, 0u, index));
        }
    }
    return vec4<f32>(vec3<f32>(light / f32(view.spp)), 1.0);
}

// A point of the floor, seen from above, and one of the lamp; the ball hangs between.
fn lit(at: vec2<f32>, on_lamp: vec2<f32>) -> f32 {
    let floor_ = vec3<f32>(2.0 * at / f32(view.size) - 1.0, 0.0);
    let lamp = vec3<f32>(1.2 * on_lamp - 0.6, 2.0);
    let way = lamp - floor_;
    let ball = vec3<f32>(0.0, 0.0, 0.7) - floor_;
    let miss = ball - way * dot(ball, way) / dot(way, way);
    return select(3.5 * way.z * way.z / pow(dot(way, way), 2.0), 0.0, dot(miss, miss) < 0.16);
}
";

fn main() -> ExitCode {
    let path = std::env::args().nth(1).unwrap_or_else(|| "full_screen.png".into());
    match pollster::block_on(picture()).and_then(|picture| save(&path, &picture)) {
        Ok(()) => {
            println!("written to {path}: white noise on the left, Sampler on the right, one sample a pixel");
            ExitCode::SUCCESS
        }
        Err(line) => {
            eprintln!("error: {line}");
            ExitCode::FAILURE
        }
    }
}

/// Renders it; RGBA, 8 bits.
async fn picture() -> Result<Vec<u8>, String> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::VULKAN;
    let adapter = wgpu::Instance::new(descriptor).request_adapter(&wgpu::RequestAdapterOptions::default()).await;
    let cure = "install one in software by `apt-get install mesa-vulkan-drivers libvulkan1`";
    let adapter = adapter.map_err(|_| format!("there is no Vulkan device: {cure}"))?;
    let opened = adapter.request_device(&wgpu::DeviceDescriptor::default()).await;
    let (device, queue) = opened.map_err(|error| format!("the device cannot be opened ({error}): {cure}"))?;

    // The library's functions, its table's binding, and the shader that uses them.
    let text: String = shader::SAMPLER.and(shader::WHITE).texts().chain([shader::NET.storage, MINE]).collect();
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("soft shadow"),
        source: wgpu::ShaderSource::Wgsl(text.into()),
    });
    let format = wgpu::TextureFormat::Rgba8UnormSrgb;
    let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("corners"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("color"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(format.into())],
        }),
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        multiview_mask: None,
        cache: None,
    });

    // Group 0: the table, uploaded once. Group 1: what changes from frame to frame.
    let words: Vec<u32> = shader::net_words().collect();
    let view: View = [SIZE, 1, 1, 0];
    let buffer = |words: &[u32], usage| {
        let contents = bytemuck::cast_slice(words);
        device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage })
    };
    let (table, view) = (buffer(&words, wgpu::BufferUsages::STORAGE), buffer(&view, wgpu::BufferUsages::UNIFORM));
    // The pipeline's own layout has what the shader reads and no more: of `Dithered` drawn in pairs, one mask.
    let bind = |group, binding, buffer: &wgpu::Buffer| {
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(group),
            entries: &[wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() }],
        })
    };
    let (table, view) = (bind(0, shader::NET.binding, &table), bind(1, 0, &view));

    let extent = wgpu::Extent3d { width: SIZE, height: SIZE, depth_or_array_layers: 1 };
    let target = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: extent,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    });
    let copy = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(4 * SIZE * SIZE),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &target.create_view(&wgpu::TextureViewDescriptor::default()),
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations::default(),
            })],
            ..Default::default()
        });
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &table, &[]);
        pass.set_bind_group(1, &view, &[]);
        pass.draw(0..3, 0..1);
    }
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * SIZE), rows_per_image: None };
    encoder.copy_texture_to_buffer(target.as_image_copy(), wgpu::TexelCopyBufferInfo { buffer: &copy, layout }, extent);
    queue.submit([encoder.finish()]);
    copy.map_async(wgpu::MapMode::Read, .., |_| ());
    device.poll(wgpu::PollType::wait_indefinitely()).map_err(|error| format!("the device is lost: {error}"))?;
    let mapped = copy.get_mapped_range(..).map_err(|error| format!("the picture cannot be read: {error}"))?;
    Ok(mapped.to_vec())
}

fn save(path: &str, picture: &[u8]) -> Result<(), String> {
    let refusal = |error: &dyn std::fmt::Display| format!("{path} cannot be written ({error}): name another file");
    let file = std::fs::File::create(path).map_err(|error| refusal(&error))?;
    let mut encoder = png::Encoder::new(std::io::BufWriter::new(file), SIZE, SIZE);
    encoder.set_color(png::ColorType::Rgba);
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(picture)?;
        writer.finish()
    });
    written.map_err(|error| refusal(&error))
}
