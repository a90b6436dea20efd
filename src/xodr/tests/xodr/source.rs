//! Bytes of many forms, and the text, notes and refusals that they come to.

use flate2::{Compression, write::GzEncoder};
use mapd_xodr::source::{Inputs, NoteKind, RefusalKind, Source, SourceLimits};
use std::io::{self, BufRead as _, Read, Write as _};

/// Hands out a few bytes at a time, so that characters are torn apart.
struct Slow<'a>(&'a [u8], usize);

impl Read for Slow<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.0.len().min(self.1).min(buffer.len());
        let (now, rest) = self.0.split_at(count);
        buffer[..count].copy_from_slice(now);
        self.0 = rest;
        Ok(count)
    }
}

#[derive(Debug, PartialEq)]
struct Outcome {
    text: String,
    encoding: &'static str,
    notes: Vec<(u64, u32, NoteKind)>,
    refusal: Option<(u64, RefusalKind)>,
}

/// The next piece of text, with as much room as this; without any, from the buffer.
fn next_piece(source: &mut Source<'_>, room: &mut [u8]) -> io::Result<Vec<u8>> {
    if room.is_empty() {
        let piece = source.fill_buf()?.to_vec();
        source.consume(piece.len());
        return Ok(piece);
    }
    let count = source.read(room)?;
    Ok(room[..count].to_vec())
}

fn read_from(mut source: Source<'_>, room: usize) -> Outcome {
    let (mut text, mut room) = (Vec::new(), vec![0; room]);
    let refusal = loop {
        match next_piece(&mut source, &mut room) {
            Ok(piece) if piece.is_empty() => break None,
            Ok(piece) => {
                assert!(room.len() == 1 || std::str::from_utf8(&piece).is_ok(), "a torn character");
                text.extend_from_slice(&piece);
            }
            Err(error) => {
                let refusal = Source::refusal(&error).expect("memory does not fail").clone();
                let again = next_piece(&mut source, &mut room).expect_err("a refusal comes again");
                assert_eq!(Source::refusal(&again), Some(&refusal));
                break Some((refusal.start, refusal.kind));
            }
        }
        assert_eq!(source.offset(), source.skipped() + text.len() as u64);
    };
    let notes = source.take_notes().into_iter().map(|n| (n.start, n.len, n.kind)).collect();
    let text = String::from_utf8(text).expect("what is handed out is UTF-8");
    assert_eq!(source.offset(), source.skipped() + text.len() as u64);
    Outcome { text, encoding: source.encoding(), notes, refusal }
}

fn read_with(bytes: &[u8], limits: SourceLimits) -> Outcome {
    let whole = read_from(Inputs::new(limits).open(Box::new(bytes), ""), 0);
    for room in [1, 1 << 16, 200_000] {
        let read = read_from(Inputs::new(limits).open(Box::new(bytes), ""), room);
        assert_eq!(read, whole, "with room for {room}");
    }
    for (step, room) in [(1, 0), (2, 1 << 16), (3, 0), (7, 1 << 16), (1000, 0), (65_535, 1 << 16)] {
        let slow = read_from(Inputs::new(limits).open(Box::new(Slow(bytes, step)), ""), room);
        assert_eq!(slow, whole, "in steps of {step} with room for {room}");
    }
    whole
}

fn read(bytes: &[u8]) -> Outcome {
    read_with(bytes, SourceLimits::default())
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).expect("memory does not fail");
    encoder.finish().expect("memory does not fail")
}

fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    text.encode_utf16().flat_map(bytes).collect()
}

/// The text comes out as expected, without notes; so it does through gzip.
#[track_caller]
fn check(bytes: &[u8], text: &str, encoding: &'static str) {
    let expected = Outcome { text: text.to_owned(), encoding, notes: Vec::new(), refusal: None };
    assert_eq!(read(bytes), expected);
    assert_eq!(read(&gzip(bytes)), expected);
}

#[test]
fn encodings_in_all_forms() {
    let plain = "<a b='Stra\u{df}e \u{20ac} \u{1f6e3}'/>\r\n";
    check(plain.as_bytes(), plain, "UTF-8");
    check(format!("\u{feff}{plain}").as_bytes(), plain, "UTF-8");
    check(b"", "", "UTF-8");
    check(&utf16(&format!("\u{feff}{plain}"), u16::to_le_bytes), plain, "UTF-16LE");
    check(&utf16(&format!("\u{feff}{plain}"), u16::to_be_bytes), plain, "UTF-16BE");
    let wide = format!("<?xml version='1.0' encoding='UTF-16'?>{plain}");
    check(&utf16(&format!("\u{feff}{wide}"), u16::to_be_bytes), &wide, "UTF-16BE");
    for (declared, used, bytes, text) in [
        ("ISO-8859-1", "ISO-8859-1", &b"\xe4\xff"[..], "\u{e4}\u{ff}"),
        ("latin1", "ISO-8859-1", b"\xa4", "\u{a4}"),
        ("Windows-1252", "windows-1252", b"\x80\xe4", "\u{20ac}\u{e4}"),
        ("ISO-8859-15", "ISO-8859-15", b"\xa4", "\u{20ac}"),
        ("GBK", "GBK", b"\xc4\xe3\xba\xc3", "\u{4f60}\u{597d}"),
        ("us-ascii", "UTF-8", "\u{e4}".as_bytes(), "\u{e4}"),
        ("utf8", "UTF-8", "\u{e4}".as_bytes(), "\u{e4}"),
    ] {
        let head = format!("<!-- a --> <?xml version=\"1.0\" encoding=\"{declared}\"?><a>");
        let document = [head.as_bytes(), bytes, b"</a>"].concat();
        check(&document, &format!("{head}{text}</a>"), used);
    }
}

#[test]
fn long_texts_pass_whole() {
    let long = format!("<a>{}</a>", "\u{e4}\u{20ac}\u{1f6e3}x\n".repeat(40_000));
    check(long.as_bytes(), &long, "UTF-8");
    check(&utf16(&format!("\u{feff}{long}"), u16::to_le_bytes), &long, "UTF-16LE");
    let head = "<?xml version='1.0' encoding='latin1'?>";
    let document = [head.as_bytes(), &[0xe4; 200_000]].concat();
    check(&document, &format!("{head}{}", "\u{e4}".repeat(200_000)), "ISO-8859-1");
}

#[test]
fn gzip_members_follow_each_other() {
    let document = [gzip(b"<a>"), gzip(b"</a>")].concat();
    assert_eq!(read(&document).text, "<a></a>");
    assert_eq!(read(&gzip(&gzip(b"<a/>"))).refusal, Some((0, RefusalKind::NestedGzip)));
}

#[test]
fn damaged_gzip_gives_the_text_before_the_damage() {
    let text = (0..20_000_u32).map(|i| format!("<a b='{}'/>", i.wrapping_mul(2_654_435_761)));
    let text = text.collect::<String>();
    let whole = gzip(text.as_bytes());
    for len in [3, 9, 100, whole.len() / 2, whole.len() - 1] {
        let read = read(&whole[..len]);
        assert!(text.starts_with(&read.text));
        assert!(len < 1000 || read.text.len() > text.len() / 3, "{len}: {}", read.text.len());
        let (at, kind) = read.refusal.expect("a refusal");
        assert_eq!(at, read.text.len() as u64);
        assert!(matches!(kind, RefusalKind::Gzip(_)), "{kind}");
    }
    let mut damaged = whole.clone();
    let last = damaged.len() - 6;
    damaged[last] ^= 1;
    assert!(matches!(read(&damaged).refusal, Some((_, RefusalKind::Gzip(_)))));
}

#[test]
fn notes() {
    use NoteKind::*;
    let disagrees =
        |declared: &str, used| EncodingDisagrees { declared: declared.to_owned(), used };
    let utf16_declared = "<?xml version='1.0' encoding='UTF-16'?>";
    let latin_declared = "<?xml version='1.0' encoding='latin1'?>";
    for (document, text, expected) in [
        (b"junk <a/>".to_vec(), "<a/>", vec![(0, 5, TextBeforeMarkup)]),
        (b" \n<a/>".to_vec(), " \n<a/>", vec![]),
        ("\u{feff}\u{feff}<a/>".as_bytes().to_vec(), "<a/>", vec![(0, 3, TextBeforeMarkup)]),
        (
            b"<a>\x01\0</a>".to_vec(),
            "<a>\x01\0</a>",
            vec![(3, 1, IllegalCharacter('\x01')), (4, 1, IllegalCharacter('\0'))],
        ),
        (
            "<a>\u{ffff}".as_bytes().to_vec(),
            "<a>\u{ffff}",
            vec![(3, 3, IllegalCharacter('\u{ffff}'))],
        ),
        (utf16("<a/>", u16::to_be_bytes), "<a/>", vec![(0, 1, NoByteOrderMark)]),
        (
            utf16_declared.as_bytes().to_vec(),
            utf16_declared,
            vec![(0, 5, disagrees("UTF-16", "UTF-8"))],
        ),
        (
            format!("\u{feff}{latin_declared}").into_bytes(),
            latin_declared,
            vec![(0, 5, disagrees("latin1", "UTF-8"))],
        ),
        (
            [latin_declared.as_bytes(), b"\x80\x81"].concat(),
            "<?xml version='1.0' encoding='latin1'?>\u{80}\u{81}",
            vec![(39, 2, ControlInLatin1)],
        ),
    ] {
        let read = read(&document);
        assert_eq!((read.text.as_str(), &read.notes, &read.refusal), (text, &expected, &None));
    }
    let many = read(&[b'<', 1, 1, 1].repeat(1000));
    assert_eq!(many.notes.len(), 65);
    assert_eq!(many.notes.last().map(|note| &note.2), Some(&MoreIllegalCharacters));
}

#[test]
fn refusals() {
    let declared = |name: &str| format!("<?xml version='1.0' encoding='{name}'?>");
    let unknown = |name: &str| RefusalKind::UnknownEncoding(name.to_owned());
    for (document, text, kind) in [
        (b"<a>\xff</a>".to_vec(), "<a>", RefusalKind::InvalidBytes("UTF-8")),
        (b"<a>\xe4\xbd".to_vec(), "<a>", RefusalKind::InvalidBytes("UTF-8")),
        (b"\xff\xfe<\0a\0\0\xd8".to_vec(), "<a", RefusalKind::InvalidBytes("UTF-16LE")),
        (b"\xff\xfe<\0a".to_vec(), "<", RefusalKind::InvalidBytes("UTF-16LE")),
        (b"\xff\xfe\0\0<\0\0\0".to_vec(), "", unknown("UTF-32")),
        (declared("klingon").into_bytes(), "", unknown("klingon")),
        (declared("ISO-2022-JP").into_bytes(), "", unknown("ISO-2022-JP")),
        (declared("UTF-7").into_bytes(), "", unknown("UTF-7")),
    ] {
        let read = read(&document);
        assert_eq!((read.text.as_str(), read.refusal), (text, Some((text.len() as u64, kind))));
    }
}

/// What is read where it stays, which the beginning of a document is not, comes out as all else.
#[test]
fn faults_behind_long_text() {
    for head in [65_533, 65_536, 131_071, 200_000] {
        let head = format!("<a>{}", "\u{e4}\u{20ac}\u{1f6e3}x\n".repeat(head / 11));
        let at = head.len() as u64;
        for (tail, text, notes, refusal) in [
            (&b"</a>"[..], "</a>", &[][..], None),
            (b"<b>\xff</b>", "<b>", &[], Some((3, RefusalKind::InvalidBytes("UTF-8")))),
            (b"<b>\xe4\xbd", "<b>", &[], Some((3, RefusalKind::InvalidBytes("UTF-8")))),
            (b"<b\x01/>", "<b\x01/>", &[(2, 1, '\x01')], None),
            ("\u{fffe}</a>".as_bytes(), "\u{fffe}</a>", &[(0, 3, '\u{fffe}')], None),
        ] {
            let of_note = |(start, len, character): &(u64, u32, char)| {
                (at + start, *len, NoteKind::IllegalCharacter(*character))
            };
            let expected = Outcome {
                text: format!("{head}{text}"),
                encoding: "UTF-8",
                notes: notes.iter().map(of_note).collect(),
                refusal: refusal.map(|(start, kind)| (at + start, kind)),
            };
            assert_eq!(read(&[head.as_bytes(), tail].concat()), expected);
        }
        for fewer in 0..12 {
            let decoded_bytes = at - fewer;
            let limits = SourceLimits { decoded_bytes, ..SourceLimits::default() };
            let read = read_with(head.as_bytes(), limits);
            assert!(head.starts_with(&read.text), "{fewer}");
            let kind = RefusalKind::DecodedBytes(decoded_bytes);
            let refusal = (fewer > 0).then_some((read.text.len() as u64, kind));
            assert_eq!(read.refusal, refusal, "{fewer}");
        }
    }
}

#[test]
fn limits() {
    let limits = SourceLimits { decoded_bytes: 10, ..SourceLimits::default() };
    assert_eq!(read_with(b"<a>5678901", limits).refusal, None);
    let too_long = read_with(b"<a>56789012", limits);
    assert_eq!(
        (too_long.text.as_str(), too_long.refusal),
        ("<a>5678901", Some((10, RefusalKind::DecodedBytes(10))))
    );
    let torn = read_with("<a>567890\u{e4}".as_bytes(), limits);
    assert_eq!(
        (torn.text.as_str(), torn.refusal),
        ("<a>567890", Some((9, RefusalKind::DecodedBytes(10))))
    );

    let limits = SourceLimits { gzip_grace: 1 << 16, ..SourceLimits::default() };
    let bomb = gzip(&vec![b' '; 1 << 20]);
    let bomb = read_from(Inputs::new(limits).open(Box::new(&bomb[..]), ""), 0);
    assert!(matches!(bomb.refusal, Some((_, RefusalKind::GzipRatio(256)))), "{:?}", bomb.refusal);
    assert_eq!(read(&gzip(&vec![b' '; 1 << 20])).refusal, None);

    let mut inputs = Inputs::new(SourceLimits::default());
    let document = vec![b'x'; 1 << 20];
    let mut source = inputs.open(Box::new(&document[..]), "");
    for _ in 0..2 {
        source.begin_piece(1 << 16);
        let mut taken = 0;
        let error = loop {
            match source.fill_buf().map(<[u8]>::len) {
                Ok(count) => {
                    source.consume(count);
                    taken += count;
                }
                Err(error) => break error,
            }
        };
        let kind = Source::refusal(&error).map(|refusal| refusal.kind.clone());
        assert_eq!(kind, Some(RefusalKind::Piece(1 << 16)));
        assert!(taken <= 3 << 16, "{taken}");
    }
}

#[test]
fn a_failing_input_is_an_error_of_the_environment() {
    struct Failing(u8);
    impl Read for Failing {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            self.0 += 1;
            match self.0 {
                1 => Err(io::ErrorKind::Interrupted.into()),
                2 => (&b"<a>"[..]).read(buffer),
                _ => Err(io::Error::other("unplugged")),
            }
        }
    }
    let mut source = Inputs::new(SourceLimits::default()).open(Box::new(Failing(0)), "");
    let error = source.fill_buf().expect_err("it fails");
    assert!(Source::refusal(&error).is_none());
    assert_eq!(error.to_string(), "unplugged");
}
