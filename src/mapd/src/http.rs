//! What the two small servers of pages, `mapd view` and `--metrics`, understand of HTTP: `GET` and `HEAD` of a path, asked of this machine.
//!
//! A page of somebody else that knows the port must not read what is served. It is kept out by the names that a request may have for this
//! machine (a name of its own that leads here, as by DNS rebinding, is refused), and by browsers themselves, because nothing allows another
//! origin.

use std::net::IpAddr;

/// Longest head of a request \[bytes\].
pub(crate) const LONGEST_HEAD: usize = 8 << 10;

/// Lines of the head of each answer: no page but its own reads or frames it, and nobody keeps it.
pub(crate) const HEADERS: &str = "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\nX-Frame-Options: DENY\r\nConnection: close\r\n";

/// Port of a `Host` that names none.
const PORT: u16 = 80;

/// The methods that are understood, as the header `Allow` has them.
const ALLOWED: &str = "GET, HEAD";

/// Where a server can be asked.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Door {
    pub(crate) port: u16,
    /// Whether other machines may ask, by any address of this one.
    pub(crate) is_open: bool,
}

/// What a request asks for.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Asked<'a> {
    /// Without what is asked beyond the path, which is for the page.
    pub(crate) path: &'a str,
    /// Whether only the head of the answer is wanted.
    pub(crate) is_head: bool,
}

/// Why a request is not answered.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Refusal {
    /// Code and words.
    pub(crate) status: &'static str,
    /// Further lines of the head.
    pub(crate) more: String,
    pub(crate) message: &'static str,
}

/// Whether the head of a request has arrived.
pub(crate) fn is_whole(head: &[u8]) -> bool {
    head.windows(4).any(|end| end == b"\r\n\r\n")
}

/// What the head of a request asks for.
///
/// Errors: it is not asked of this machine, or by another method.
pub(crate) fn understood(head: &str, door: Door) -> Result<Asked<'_>, Refusal> {
    let mut words = head.split(' ');
    let (method, path) = (words.next(), words.next().unwrap_or_default());
    if !host(head).is_some_and(|host| door.is_named(host)) {
        let message = "this name is not this machine's: ask by its address and port";
        return Err(Refusal { status: "403 Forbidden", more: String::new(), message });
    }
    let is_head = match method {
        Some("GET") => false,
        Some("HEAD") => true,
        _ => {
            let (status, more) = ("405 Method Not Allowed", format!("Allow: {ALLOWED}\r\n"));
            return Err(Refusal { status, more, message: "only GET and HEAD" });
        }
    };
    Ok(Asked { path: path.split_once('?').map_or(path, |(path, _)| path), is_head })
}

impl Door {
    /// Whether a `Host` names this machine and port: by an address of its own or as `localhost`; where other machines may ask, also by the
    /// machine's own name.
    fn is_named(self, host: &str) -> bool {
        let (name, port) = match host.rsplit_once(':') {
            Some((name, port)) if !port.ends_with(']') => (name, port.parse().ok()),
            _ => (host, Some(PORT)),
        };
        let name = name.trim_start_matches('[').trim_end_matches(']');
        let address = name.parse::<IpAddr>();
        let is_us = || rustix::system::uname().nodename().to_bytes() == name.as_bytes();
        let is_named = name.eq_ignore_ascii_case("localhost")
            || address.is_ok_and(|address| self.is_open || address.is_loopback())
            || (self.is_open && !name.is_empty() && is_us());
        is_named && port == Some(self.port)
    }
}

/// The value of the only `Host`.
fn host(head: &str) -> Option<&str> {
    let fields = head.lines().skip(1).filter_map(|line| line.split_once(':'));
    let mut hosts = fields.filter(|(name, _)| name.eq_ignore_ascii_case("host"));
    match (hosts.next(), hosts.next()) {
        (Some((_, host)), None) => Some(host.trim()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_this_machine_is_asked() {
        let own = rustix::system::uname().nodename().to_string_lossy().into_owned();
        let own_and_port = format!("{own}:9464");
        for (host, port, closed, open) in [
            ("127.0.0.1:9464", 9464, true, true),
            ("127.8.9.1:9464", 9464, true, true),
            ("LocalHost:9464", 9464, true, true),
            ("[::1]:9464", 9464, true, true),
            ("localhost", 80, true, true),
            ("[::1]", 80, true, true),
            ("192.0.2.1:9464", 9464, false, true),
            (own_and_port.as_str(), 9464, own == "localhost", true),
            ("127.0.0.1", 9464, false, false),
            ("127.0.0.1:1", 9464, false, false),
            ("127.0.0.1:", 9464, false, false),
            ("127.0.0.1:9464:9464", 9464, false, false),
            ("evil.example:9464", 9464, false, false),
            ("127.0.0.1.evil.example:9464", 9464, false, false),
            ("localhost.evil.example:9464", 9464, false, false),
            (":9464", 9464, false, false),
            ("", 80, false, false),
        ] {
            for (is_open, is_answered) in [(false, closed), (true, open)] {
                let head = format!("GET / HTTP/1.1\r\nhost: {host}\r\n\r\n");
                let answered = understood(&head, Door { port, is_open });
                assert_eq!(answered.is_ok(), is_answered, "{host} {is_open}");
            }
        }
        let door = Door { port: 1, is_open: false };
        for head in [
            "GET / HTTP/1.1\r\n\r\n",
            "GET / HTTP/1.1\r\nHost: localhost:1\r\nHost: localhost:1\r\n\r\n",
            "",
        ] {
            assert!(understood(head, door).is_err(), "{head}");
        }
        let ask = |line: &str| {
            understood(&format!("{line}\r\nHost: localhost:1\r\n\r\n"), door)
                .map(|asked| (asked.path.to_owned(), asked.is_head))
                .map_err(|refusal| (refusal.status, refusal.more))
        };
        assert_eq!(ask("GET /metrics?a=b HTTP/1.1"), Ok(("/metrics".to_owned(), false)));
        assert_eq!(ask("HEAD / HTTP/1.1"), Ok(("/".to_owned(), true)));
        for method in ["POST", "OPTIONS", "get", "TRACE", ""] {
            let refused = ("405 Method Not Allowed", "Allow: GET, HEAD\r\n".to_owned());
            assert_eq!(ask(&format!("{method} / HTTP/1.1")), Err(refused), "{method}");
        }
    }
}
