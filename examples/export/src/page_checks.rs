//! The page in a browser: what it shows, measures and says.

use crate::browser::Browser;
use crate::page;
use std::path::PathBuf;

/// The page's file, and where screenshots go.
fn written() -> (PathBuf, String) {
    let folder = std::env::current_exe().expect("this test has a path").with_file_name("page-checks");
    std::fs::create_dir_all(&folder).expect("a folder beside this test");
    let file = folder.join("index.html");
    std::fs::write(&file, page::page()).expect("a file beside this test");
    let url = format!("file://{}?reference=64", file.display());
    (folder, url)
}

/// The filtered error of the sampler on the right, relative to white noise.
fn right_error(browser: &Browser) -> f64 {
    let text = browser.run("return document.getElementById('right-error').value");
    let number = text.trim_matches('"').split(' ').next().and_then(|number| number.parse().ok());
    number.unwrap_or_else(|| panic!("no error is shown: {text}"))
}

fn set(browser: &Browser, id: &str, property: &str, value: &str) {
    browser.run(&format!(
        "delete document.body.dataset.measured; const control = document.getElementById('{id}'); \
         control.{property} = {value}; control.dispatchEvent(new Event('input', {{ bubbles: true }}));"
    ));
}

/// The page measures what it shows: with one sample and with four blue noise leaves less after the filter, for the
/// eye's purpose; the console stays empty; light and dark, on a screen and on a phone.
#[test]
#[ignore = "needs chromium-driver"]
fn the_page_runs() {
    let (folder, url) = written();
    let browser = Browser::open(&url, 900, 760, &[]);
    browser.wait("return document.body.dataset.measured !== undefined");
    let samples = browser.screenshot(&folder.join("light.png"));
    let colors: std::collections::BTreeSet<_> = samples.as_chunks::<3>().0.iter().collect();
    assert!(colors.len() > 1000, "text has few colours, and pictures many: {}", colors.len());
    let one = right_error(&browser);
    assert!(one < 0.8, "one sample a pixel: {one}");
    set(&browser, "samples", "value", "2");
    browser.wait("return document.body.dataset.measured === '4 still'");
    let four = right_error(&browser);
    assert!(four < 1.0, "four samples a pixel: {four}");
    println!("filtered error relative to white noise: {one} at one sample a pixel, {four} at four");
    for word in ["keyed", "dithered", "white"] {
        set(&browser, "right", "value", &format!("'{word}'"));
        browser.wait("return document.body.dataset.measured === '4 still'");
        let error = right_error(&browser);
        println!("{word}: {error}");
        assert!(error < 1.0 || word == "white", "{word} at four samples a pixel: {error}");
    }
    assert_eq!(right_error(&browser), 1.0, "white noise is itself");
    for mode in ["animated", "averaged"] {
        browser.run(&format!("document.querySelector('input[value={mode}]').click()"));
        browser.wait(&format!("return document.body.dataset.measured === '4 {mode}'"));
    }
    let views: usize =
        browser.run("return document.querySelectorAll('input[name=view]').length").parse().expect("a count");
    assert!(views > 1, "{views} views");
    for view in 0..views {
        browser.run(&format!("document.querySelectorAll('input[name=view]')[{view}].click()"));
        browser.run("document.body.dataset.drawn = ''; requestAnimationFrame(() => requestAnimationFrame(() => document.body.dataset.drawn = 'yes'))");
        browser.wait("return document.body.dataset.drawn === 'yes'");
    }
    assert_eq!(browser.log().replace(' ', ""), r#"{"value":[]}"#);
}

#[test]
#[ignore = "needs chromium-driver"]
fn the_page_is_readable_on_a_phone_in_the_dark() {
    let (folder, url) = written();
    let browser = Browser::open(&url, 500, 1100, &["--force-dark-mode", "--blink-settings=preferredColorScheme=0"]);
    browser.wait("return document.body.dataset.measured !== undefined");
    browser.screenshot(&folder.join("dark.png"));
    assert_eq!(browser.run("return document.documentElement.scrollWidth <= window.innerWidth"), "true");
    assert_eq!(browser.run("return getComputedStyle(document.body).backgroundColor"), "\"rgb(20, 22, 25)\"");
    assert_eq!(browser.log().replace(' ', ""), r#"{"value":[]}"#);
}

/// Without WebGPU there is a note, and no empty picture.
#[test]
#[ignore = "needs chromium-driver"]
fn without_webgpu_there_is_a_note() {
    let (_, url) = written();
    let browser = Browser::open(&url, 900, 760, &["--disable-features=WebGPU", "--disable-gpu"]);
    browser.wait(
        "return document.getElementById('missing').textContent.startsWith('This page needs JavaScript') === false",
    );
    assert_eq!(browser.run("return document.getElementById('app').hidden"), "true");
}
