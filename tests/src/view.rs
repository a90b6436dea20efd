//! `mapd view` as a process, and requests to it.

use crate::test_domain::{PATIENCE, TestDomain};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Stdio};

/// A process that serves maps to browsers. Dropping it kills it.
pub struct View {
    child: Child,
    port: u16,
}

impl View {
    /// Starts it in a domain, and returns once it has said where it serves.
    pub fn start(place: &TestDomain, arguments: &[&str]) -> Self {
        let mut command = place.command();
        let mut child =
            command.arg("view").args(arguments).stdout(Stdio::piped()).spawn().expect("runs");
        let mut line = String::new();
        let out = child.stdout.take().expect("a pipe");
        BufReader::new(out).read_line(&mut line).expect("an address");
        let port = line.trim().trim_end_matches('/').rsplit(':').next().expect("a port");
        Self { port: port.parse().unwrap_or_else(|_| panic!("{line}")), child }
    }

    /// Where its page is.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Sends a request as it is written, with the port in the place of `PORT`.
    pub fn send(&self, request: &str) -> BufReader<TcpStream> {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).expect("connects");
        stream.set_read_timeout(Some(PATIENCE)).expect("a timeout");
        let request = request.replace("PORT", &self.port.to_string());
        stream.write_all(request.as_bytes()).expect("sent");
        BufReader::new(stream)
    }

    /// Sends a request likewise: status and body of the answer.
    pub fn ask(&self, request: &str) -> (u16, Vec<u8>) {
        let mut answer = Vec::new();
        self.send(request).read_to_end(&mut answer).expect("an answer");
        let end = answer.windows(4).position(|end| end == b"\r\n\r\n").expect("a head");
        let head = String::from_utf8_lossy(&answer[..end]).into_owned();
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok());
        (status.unwrap_or_else(|| panic!("{head}")), answer.split_off(end + 4))
    }
}

impl Drop for View {
    fn drop(&mut self) {
        // It may have ended.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
