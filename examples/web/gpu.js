// The device, a pipeline for each sampler, and images: buffers of sums.

// x, y, z, radius, red, green, blue, gloss.
const BALLS = [
    [-0.15, 0.9, -0.2, 0.9, 0.62, 0.07, 0.05, 0.05],
    [1.55, 0.5, 0.9, 0.5, 0.90, 0.62, 0.12, 0.04],
    [-1.75, 0.42, 1.4, 0.42, 0.08, 0.42, 0.42, 0.04],
    [0.55, 0.24, 1.9, 0.24, 0.86, 0.84, 0.80, 0.04],
    [-2.9, 1.1, -3.2, 1.1, 0.60, 0.58, 0.55, 0.04],
    [2.9, 0.8, -3.4, 0.8, 0.07, 0.16, 0.48, 0.05],
    [0.9, 0.6, -6.5, 0.6, 0.18, 0.46, 0.22, 0.04],
];

class Gpu {
    // Null where there is no WebGPU.
    static async open() {
        const adapter = await navigator.gpu?.requestAdapter();
        return adapter ? new Gpu(await adapter.requestDevice()) : null;
    }

    constructor(device) {
        this.device = device;
        this.pipelines = new Map();
        this.format = navigator.gpu.getPreferredCanvasFormat();
        const module = device.createShaderModule({ code: DATA.show });
        this.showing = device.createRenderPipeline({
            layout: "auto",
            vertex: { module, entryPoint: "corners" },
            fragment: { module, entryPoint: "color", targets: [{ format: this.format }] },
        });
        this.balls = this.upload(new Float32Array(BALLS.flat()));
        this.tables = new Map();
    }

    upload(data) {
        const usage = GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST;
        const buffer = this.device.createBuffer({ size: data.byteLength, usage });
        this.device.queue.writeBuffer(buffer, 0, data);
        return buffer;
    }

    image(width, height) {
        const usage = GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC;
        return this.device.createBuffer({ size: 16 * width * height, usage });
    }

    // What a sampler's bindings hold.
    tablesOf(sampler) {
        if (!this.tables.has(sampler.word)) {
            const entry = ({ binding, base64 }) => this.entry(binding, this.upload(bytes(base64)));
            this.tables.set(sampler.word, sampler.tables.map(entry));
        }
        return this.tables.get(sampler.word);
    }

    // The scene's shader, for one sampler: its functions, its tables, and its word in the scene. Said in full, since a
    // table that the scene happens not to read would be missing in an automatic layout.
    pipeline(sampler) {
        if (!this.pipelines.has(sampler.word)) {
            const code = sampler.wgsl + DATA.scene.replaceAll("SAMPLER", sampler.word);
            const module = this.device.createShaderModule({ code });
            const kinds = sampler.tables.map(({ binding }) => [binding, "read-only-storage"]);
            kinds.push([13, "read-only-storage"], [14, "uniform"], [15, "storage"]);
            const entries = kinds.map(([binding, type]) => {
                return { binding, visibility: GPUShaderStage.COMPUTE, buffer: { type } };
            });
            const layout = this.device.createPipelineLayout({
                bindGroupLayouts: [this.device.createBindGroupLayout({ entries })],
            });
            const compute = { module, entryPoint: "render" };
            this.pipelines.set(sampler.word, this.device.createComputePipeline({ layout, compute }));
        }
        return this.pipelines.get(sampler.word);
    }

    // Adds samples to an image, or begins it anew. `view` is what the shader's View holds.
    render(sampler, image, { width, height, seed, spp, frame, first, count, sampled, add }) {
        const pipeline = this.pipeline(sampler);
        const words = new Uint32Array([width, height, seed, spp, frame, first, count, sampled, add, 0]);
        const view = this.uniform(words);
        const own = [[13, this.balls], [14, view], [15, image]].map(([binding, buffer]) => this.entry(binding, buffer));
        const layout = pipeline.getBindGroupLayout(0);
        const group = this.device.createBindGroup({ layout, entries: [...this.tablesOf(sampler), ...own] });
        const encoder = this.device.createCommandEncoder();
        const pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        pass.dispatchWorkgroups(Math.ceil(width / 8), Math.ceil(height / 8));
        pass.end();
        this.device.queue.submit([encoder.finish()]);
        view.destroy();
    }

    show(context, image, reference, { width, height, mode }) {
        const show = this.uniform(new Uint32Array([width, height, mode, 0]));
        const layout = this.showing.getBindGroupLayout(0);
        const entries = [show, image, reference].map((buffer, binding) => this.entry(binding, buffer));
        const group = this.device.createBindGroup({ layout, entries });
        const encoder = this.device.createCommandEncoder();
        const view = context.getCurrentTexture().createView();
        const pass = encoder.beginRenderPass({ colorAttachments: [{ view, loadOp: "clear", storeOp: "store" }] });
        pass.setPipeline(this.showing);
        pass.setBindGroup(0, group);
        pass.draw(3);
        pass.end();
        this.device.queue.submit([encoder.finish()]);
        show.destroy();
    }

    context(canvas) {
        const context = canvas.getContext("webgpu");
        context.configure({ device: this.device, format: this.format, alphaMode: "opaque" });
        return context;
    }

    async read(image) {
        const usage = GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ;
        const copy = this.device.createBuffer({ size: image.size, usage });
        const encoder = this.device.createCommandEncoder();
        encoder.copyBufferToBuffer(image, 0, copy, 0, image.size);
        this.device.queue.submit([encoder.finish()]);
        await copy.mapAsync(GPUMapMode.READ);
        const values = new Float32Array(copy.getMappedRange().slice(0));
        copy.destroy();
        return values;
    }

    uniform(words) {
        const usage = GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST;
        const buffer = this.device.createBuffer({ size: words.byteLength, usage });
        this.device.queue.writeBuffer(buffer, 0, words);
        return buffer;
    }

    entry(binding, buffer) {
        return { binding, resource: { buffer } };
    }
}

function bytes(base64) {
    return Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));
}
