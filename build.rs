fn main() {
    let out = std::env::var("OUT_DIR").unwrap();
    std::fs::write(format!("{out}/tables.rs"), "/// t\npub static THRESHOLD_64: ScalarMask<64> = ScalarMask::new([[0; 64]; 64]);\n/// t\npub static OFFSET_2D_64: VectorMask<2, 64> = VectorMask::new([[[0; 2]; 64]; 64]);\n").unwrap();
}
