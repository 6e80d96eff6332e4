// Controls, and what is rendered when: nothing while nothing changes.

// How well the truth is known: index.html?reference=64 is for slow devices.
const REFERENCE_SAMPLES = Number(new URLSearchParams(location.search).get("reference")) || 1024;
const REFERENCE_STEP = 8;
const byId = id => document.getElementById(id);
const chosen = name => document.querySelector(`input[name=${name}]:checked`).value;
const white = DATA.samplers.find(sampler => sampler.word === "white");

class Side {
    constructor(gpu, name, word) {
        this.canvas = byId(`${name}-canvas`);
        this.error = byId(`${name}-error`);
        this.select = byId(name);
        for (const { name, word } of DATA.samplers) {
            this.select.add(new Option(name, word));
        }
        this.select.value = word;
        this.context = gpu.context(this.canvas);
    }

    get sampler() {
        return DATA.samplers.find(sampler => sampler.word === this.select.value);
    }
}

class Page {
    constructor(gpu) {
        this.gpu = gpu;
        this.sides = [new Side(gpu, "left", "white"), new Side(gpu, "right", "sampler")];
        this.frame = 0;
        this.resize();
        byId("app").addEventListener("input", event => this.changed(event.target));
        addEventListener("resize", () => this.resize());
        requestAnimationFrame(() => this.tick());
    }

    get spp() {
        return 2 ** byId("samples").value;
    }

    get view() {
        const sampled = Number(byId("lens").checked) | Number(byId("light").checked) << 1;
        const { width, height } = this;
        return { width, height, seed: 1, spp: this.spp, frame: this.frame, first: 0, count: this.spp, sampled, add: 0 };
    }

    changed(control) {
        byId("samples-shown").value = this.spp;
        if (control.name === "zoom") {
            this.resize();
        } else if (control.type === "checkbox") {
            this.forget();
        } else {
            this.frame = 0;
            this.stale = true;
        }
    }

    // As many pixels as fit, each of whole pixels of the screen.
    resize() {
        const zoom = Number(chosen("zoom")) * Math.max(1, Math.floor(devicePixelRatio));
        const room = document.querySelector("figure").clientWidth * devicePixelRatio / zoom;
        const width = Math.max(64, Math.min(640, Math.floor(room)));
        const height = Math.floor(width * 2 / 3);
        for (const { canvas } of this.sides) {
            canvas.style.width = `${width * zoom / devicePixelRatio}px`;
            canvas.style.height = `${height * zoom / devicePixelRatio}px`;
        }
        if (width === this.width) {
            return;
        }
        Object.assign(this, { width, height });
        for (const side of this.sides) {
            Object.assign(side.canvas, { width, height });
            side.image?.destroy();
            side.image = this.gpu.image(width, height);
        }
        this.reference?.destroy();
        this.reference = this.gpu.image(width, height);
        this.whiteImage?.destroy();
        this.whiteImage = this.gpu.image(width, height);
        this.forget();
    }

    // Another picture: the reference begins anew.
    forget() {
        this.known = 0;
        this.frame = 0;
        this.stale = true;
        this.sides.forEach(side => side.error.value = "");
    }

    async tick() {
        const time = chosen("time");
        if (time !== "still") {
            this.frame += 1;
            this.stale = true;
        }
        if (this.known < REFERENCE_SAMPLES) {
            this.improve();
        }
        if (this.stale) {
            this.stale = false;
            this.draw(time === "averaged" && this.frame > 1);
            this.unmeasured = true;
        }
        if (this.unmeasured && this.known >= REFERENCE_SAMPLES && (time === "still" || this.frame % 16 === 0)) {
            this.unmeasured = false;
            await this.measure();
        }
        // One frame at a time, and none once the device is lost.
        const alive = await this.gpu.device.queue.onSubmittedWorkDone().then(() => true, () => false);
        if (alive) {
            requestAnimationFrame(() => this.tick());
        }
    }

    // More samples for the reference: of a seed and frame that the pictures do not have.
    improve() {
        const some = { seed: 99, spp: REFERENCE_SAMPLES, frame: 0xffffffff, first: this.known, count: REFERENCE_STEP };
        this.gpu.render(white, this.reference, { ...this.view, ...some, add: Number(this.known > 0) });
        this.known += REFERENCE_STEP;
        if (chosen("view") >= 2) {
            this.stale = true;
        }
    }

    draw(add) {
        const view = { ...this.view, add: Number(add) };
        this.gpu.render(white, this.whiteImage, view);
        for (const side of this.sides) {
            this.gpu.render(side.sampler, side.image, view);
            const { width, height } = this;
            this.gpu.show(side.context, side.image, this.reference, { width, height, mode: chosen("view") });
        }
    }

    // What is left, relative to white noise at the same samples.
    async measure() {
        const { width, height } = this;
        const images = [this.reference, this.whiteImage, ...this.sides.map(side => side.image)];
        const [reference, base, ...found] = await Promise.all(images.map(image => this.gpu.read(image)));
        if (this.stale) {
            return; // another picture by now
        }
        const unit = errors(base, reference, width, height);
        found.forEach((image, k) => {
            const [whole, filtered] = errors(image, reference, width, height).map((error, j) => error / unit[j]);
            this.sides[k].error.value = `${filtered.toFixed(2)} filtered · ${whole.toFixed(2)} as is`;
        });
        document.body.dataset.measured = `${this.spp} ${chosen("time")}`;
    }
}

// Before anything works the page has a note of its own, which this replaces.
function missing(why) {
    byId("app").hidden = true;
    byId("missing").hidden = false;
    byId("missing").textContent = why;
}

byId("version").textContent = DATA.version;
const gpu = await Gpu.open().catch(() => null);
if (gpu) {
    gpu.device.lost.then(({ message }) => missing(`The connection to WebGPU was lost (${message}): reload the page.`));
    gpu.device.addEventListener("uncapturederror", ({ error }) => console.error(error.message));
    byId("missing").hidden = true;
    byId("app").hidden = false;
    new Page(gpu);
} else {
    missing("This page needs WebGPU, which this browser does not offer here. Recent versions of Chrome, Edge, Safari and "
        + "Firefox have it, on some systems by a switch in their settings; pages by plain http do not get it.");
}
