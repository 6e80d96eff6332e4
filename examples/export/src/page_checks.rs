//! The page in a browser: Chromium without a window, its WebGPU in software, through its WebDriver.

use crate::page;
use std::io::{Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

const FLAGS: &[&str] = &[
    "--headless",
    "--no-sandbox",
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    "--use-angle=swiftshader",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--hide-scrollbars",
];

/// A browser with one page open.
struct Browser {
    driver: Child,
    port: u16,
    session: String,
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = request(self.port, "DELETE", &format!("/session/{}", self.session), "");
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}

impl Browser {
    fn open(url: &str, width: u32, height: u32, more: &[&str]) -> Self {
        let free = TcpListener::bind("127.0.0.1:0").and_then(|socket| socket.local_addr());
        let port = free.expect("a free port").port();
        let driver = Command::new("chromedriver").arg(format!("--port={port}")).stdout(Stdio::null()).spawn();
        let driver = driver.unwrap_or_else(|error| panic!("no browser ({error}): apt-get install chromium-driver"));
        let mut browser = Self { driver, port, session: String::new() };
        let start = Instant::now();
        while TcpStream::connect(("127.0.0.1", port)).is_err() {
            assert!(start.elapsed() < Duration::from_secs(60), "chromedriver does not listen");
            sleep(Duration::from_millis(50));
        }
        let size = format!("--window-size={width},{height}");
        let flags: Vec<String> = FLAGS.iter().chain(more).chain([&&*size]).map(|flag| format!("{flag:?}")).collect();
        let answer = request(
            port,
            "POST",
            "/session",
            &format!(
                r#"{{"capabilities":{{"alwaysMatch":{{"goog:loggingPrefs":{{"browser":"ALL"}},
                "goog:chromeOptions":{{"args":[{}]}}}}}}}}"#,
                flags.join(",")
            ),
        );
        let session = answer.split("\"sessionId\":\"").nth(1).and_then(|rest| rest.split('"').next());
        browser.session = session.unwrap_or_else(|| panic!("no session: {answer}")).into();
        browser.post("url", &format!(r#"{{"url":{url:?}}}"#));
        browser
    }

    fn post(&self, what: &str, body: &str) -> String {
        request(self.port, "POST", &format!("/session/{}/{what}", self.session), body)
    }

    /// What a script returns, as JSON.
    fn run(&self, script: &str) -> String {
        let answer = self.post("execute/sync", &format!(r#"{{"script":{script:?},"args":[]}}"#));
        let value = answer.split_once("\"value\":").map(|(_, value)| value.trim_end_matches('}'));
        value.unwrap_or_else(|| panic!("{script}: {answer}")).into()
    }

    /// Waits until a script returns true.
    fn wait(&self, script: &str) {
        let start = Instant::now();
        while self.run(script) != "true" {
            assert!(start.elapsed() < Duration::from_secs(240), "{script} stays false: {}", self.log());
            sleep(Duration::from_millis(100));
        }
    }

    /// What the console shows.
    fn log(&self) -> String {
        self.post("se/log", r#"{"type":"browser"}"#)
    }

    /// Saves what is seen; the picture's samples.
    fn screenshot(&self, path: &Path) -> Vec<u8> {
        let answer = request(self.port, "GET", &format!("/session/{}/screenshot", self.session), "");
        let base64 = answer.split("\"value\":\"").nth(1).and_then(|rest| rest.split('"').next());
        let file = decoded(base64.unwrap_or_else(|| panic!("no screenshot: {answer}")));
        std::fs::write(path, &file).expect("a file beside this test");
        let mut reader = png::Decoder::new(&file[..]).read_info().expect("a PNG");
        let mut samples = vec![0; reader.output_buffer_size()];
        reader.next_frame(&mut samples).expect("a picture");
        samples
    }
}

/// One request of HTTP; the body of the answer.
fn request(port: u16, method: &str, path: &str, body: &str) -> String {
    let mut socket = TcpStream::connect(("127.0.0.1", port)).expect("chromedriver listens");
    let head = format!("{method} {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n");
    let text = format!("{head}Content-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}", body.len());
    socket.write_all(text.as_bytes()).expect("chromedriver reads");
    let mut answer = Vec::new();
    let mut part = [0; 1 << 16];
    loop {
        let text = String::from_utf8_lossy(&answer);
        if let Some((head, body)) = text.split_once("\r\n\r\n") {
            let head = head.to_lowercase();
            let length = head.lines().find_map(|line| line.strip_prefix("content-length:")?.trim().parse().ok());
            if length.is_some_and(|length: usize| body.len() >= length) {
                return body.into();
            }
        }
        let count = socket.read(&mut part).expect("chromedriver answers");
        assert!(count > 0, "half an answer: {}", String::from_utf8_lossy(&answer));
        answer.extend(&part[..count]);
    }
}

fn decoded(base64: &str) -> Vec<u8> {
    let value = |letter: u8| match letter {
        b'A'..=b'Z' => letter - b'A',
        b'a'..=b'z' => letter - b'a' + 26,
        b'0'..=b'9' => letter - b'0' + 52,
        b'+' => 62,
        _ => 63,
    };
    let groups = base64.trim_end_matches('=').as_bytes().chunks(4);
    let bytes = groups.flat_map(|group| {
        let bits = (0..4).fold(0, |bits, k| bits << 6 | u32::from(group.get(k).map_or(0, |&letter| value(letter))));
        bits.to_be_bytes()[1..group.len()].to_vec()
    });
    bytes.collect()
}

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

/// The page measures what it shows: with one sample and with four blue noise leaves less after the filter, for the eye's
/// purpose; the console stays empty; light and dark, on a screen and on a phone.
#[test]
#[ignore = "needs chromium-driver"]
fn the_page_runs() {
    let (folder, url) = written();
    let browser = Browser::open(&url, 900, 760, &[]);
    browser.wait("return document.body.dataset.measured !== undefined");
    let samples = browser.screenshot(&folder.join("light.png"));
    assert!(samples.windows(4).any(|four| four[0] != four[3]), "the page is empty");
    let one = right_error(&browser);
    assert!(one < 0.8, "one sample a pixel: {one}");
    set(&browser, "samples", "value", "2");
    browser.wait("return document.body.dataset.measured === '4 still'");
    let four = right_error(&browser);
    assert!(four < 1.0, "four samples a pixel: {four}");
    println!("filtered error relative to white noise: {one} at one sample a pixel, {four} at four");
    for word in ["z_order", "keyed", "rank1", "dithered", "constant", "white"] {
        set(&browser, "right", "value", &format!("'{word}'"));
        browser.wait("return document.body.dataset.measured === '4 still'");
        println!("{word}: {}", right_error(&browser));
    }
    assert_eq!(right_error(&browser), 1.0, "white noise is itself");
    browser.run("document.querySelector('input[value=averaged]').click()");
    browser.wait("return document.body.dataset.measured === '4 averaged'");
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
    browser.wait("return !document.getElementById('missing').hidden");
    assert_eq!(browser.run("return document.getElementById('app').hidden"), "true");
}
