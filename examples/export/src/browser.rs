//! A browser without a window: Chromium, its WebGPU in software, through its WebDriver.

use base64::prelude::*;
use std::io::{Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::path::Path;
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
    "--disable-dev-shm-usage",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--hide-scrollbars",
];

/// A browser with one page open.
pub struct Browser {
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
    pub fn open(url: &str, width: u32, height: u32, more: &[&str]) -> Self {
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
    pub fn run(&self, script: &str) -> String {
        let answer = self.post("execute/sync", &format!(r#"{{"script":{script:?},"args":[]}}"#));
        let value = answer.split_once("\"value\":").map(|(_, value)| value.trim_end_matches('}'));
        value.unwrap_or_else(|| panic!("{script}: {answer}")).into()
    }

    /// Waits until a script returns true.
    pub fn wait(&self, script: &str) {
        let start = Instant::now();
        while self.run(script) != "true" {
            assert!(start.elapsed() < Duration::from_secs(240), "{script} stays false: {}", self.log());
            sleep(Duration::from_millis(100));
        }
    }

    /// What the console shows.
    pub fn log(&self) -> String {
        self.post("se/log", r#"{"type":"browser"}"#)
    }

    /// Saves what is seen; the picture's samples.
    pub fn screenshot(&self, path: &Path) -> Vec<u8> {
        let answer = request(self.port, "GET", &format!("/session/{}/screenshot", self.session), "");
        let base64 = answer.split("\"value\":\"").nth(1).and_then(|rest| rest.split('"').next());
        let base64 = base64.unwrap_or_else(|| panic!("no screenshot: {answer}"));
        let file = BASE64_STANDARD.decode(base64).expect("base64");
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
