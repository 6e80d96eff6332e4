// How far an image is from the reference: root mean square over pixels and channels, as it is and after a Gaussian of
// one pixel. Images are sums of samples, four numbers a pixel, and in the fourth how many.

function difference(image, reference) {
    const out = new Float32Array(image.length / 4 * 3);
    for (let k = 0; k < image.length / 4; k++) {
        for (let c = 0; c < 3; c++) {
            out[3 * k + c] = image[4 * k + c] / image[4 * k + 3] - reference[4 * k + c] / reference[4 * k + 3];
        }
    }
    return out;
}

function rms(values) {
    let sum = 0;
    for (const value of values) {
        sum += value * value;
    }
    return Math.sqrt(sum / values.length);
}

// Rows, then columns; beyond the border the last pixel goes on.
function blurred(values, width, height) {
    const weights = [0, 1, 2, 3].map(x => Math.exp(-0.5 * x * x));
    const total = weights[0] + 2 * (weights[1] + weights[2] + weights[3]);
    const pass = (from, count, step, lines, lineStep) => {
        const to = new Float32Array(from.length);
        for (let line = 0; line < lines; line++) {
            for (let k = 0; k < count; k++) {
                for (let c = 0; c < 3; c++) {
                    let sum = 0;
                    for (let x = -3; x <= 3; x++) {
                        const near = Math.min(Math.max(k + x, 0), count - 1);
                        sum += weights[Math.abs(x)] * from[3 * (line * lineStep + near * step) + c];
                    }
                    to[3 * (line * lineStep + k * step) + c] = sum / total;
                }
            }
        }
        return to;
    };
    return pass(pass(values, width, 1, height, width), height, width, width, 1);
}

// Unfiltered and filtered.
function errors(image, reference, width, height) {
    const values = difference(image, reference);
    return [rms(values), rms(blurred(values, width, height))];
}
