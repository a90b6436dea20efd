//! `mapd sign`: signatures in minisign's format, beside the file.

use super::overlay::read_document;
use crate::draft;
use crate::exit::{Exit, UsageError};
use crate::printable::shown;
use crate::source::is_archive;
use anyhow::{Context, Result, bail};
use clap::Args;
use ct_codecs::{Base64, Decoder};
use mapd_archive::verify;
use mapd_client::{Snapshot, signature_path};
use mapd_overlay::{Document, Limits};
use minisign::{SecretKey, SecretKeyBox};
use serde::Serialize;
use std::io::{Cursor, IsTerminal, Write};
use std::path::{Path, PathBuf};

/// Environment variable of the secret key's password, for where nobody can type it.
const PASSWORD_VARIABLE: &str = "MAPD_SIGN_PASSWORD";

/// Length of a secret key \[bytes\]: names of algorithms, limits of the password's hash, key and checksum.
const SECRET_BYTES: usize = 158;
/// Length of a public key \[bytes\]: name of the algorithm, number and key.
const PUBLIC_BYTES: usize = 42;

/// What to sign.
#[derive(Args)]
pub(crate) struct SignCommand {
    /// Archives (.mapd), or entries of overlays (.json)
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Secret key, as `minisign -G` writes it; asks for the password, or takes MAPD_SIGN_PASSWORD
    #[arg(long, value_name = "SECRET")]
    key: PathBuf,
    /// Print JSON: a list of what was signed
    #[arg(long)]
    json: bool,
    /// Comment that is signed too [default: time, name of the file, and an archive's hash of its content]
    #[arg(long, value_name = "TEXT")]
    comment: Option<String>,
}

impl SignCommand {
    /// Signs files.
    ///
    /// Errors: as [`sign`].
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        sign(&self, out)?;
        Ok(Exit::Done)
    }
}

/// A signature that was made.
#[derive(Serialize)]
struct Signed {
    #[serde(skip_serializing_if = "Option::is_none")]
    archive: Option<PathBuf>,
    #[serde(skip_serializing_if = "Option::is_none")]
    overlay: Option<PathBuf>,
    signature: PathBuf,
    #[serde(skip_serializing_if = "Option::is_none")]
    content_hash: Option<String>,
}

/// Signs files; each is proved first, for nobody should sign what nobody can read.
///
/// Errors: the key cannot be had; a file cannot be read or does not prove; its signature cannot be written.
fn sign(args: &SignCommand, out: &mut dyn Write) -> Result<()> {
    if args.files.iter().any(|file| file == Path::new("-")) {
        bail!(UsageError("stdin cannot be signed: a signature lies beside a file".into()));
    }
    let key = secret_key(&args.key)?;
    let mut signed = Vec::new();
    for path in &args.files {
        let made = match is_archive(path) {
            true => {
                let snapshot = Snapshot::open(path)?;
                let proved = verify(snapshot.bytes()).with_context(|| path.display().to_string());
                let content = crate::report::hex(&proved?.header.content_hash);
                let signature = write(args, &key, path, snapshot.bytes(), Some(&content))?;
                let archive = Some(path.clone());
                Signed { archive, overlay: None, signature, content_hash: Some(content) }
            }
            false => {
                let text = read_entries(path)?;
                let signature = write(args, &key, path, text.as_bytes(), None)?;
                let overlay = Some(path.clone());
                Signed { archive: None, overlay, signature, content_hash: None }
            }
        };
        if !args.json {
            match &made.content_hash {
                Some(content) => writeln!(out, "{}: content {content}", shown(&made.signature))?,
                None => writeln!(out, "{}", shown(&made.signature))?,
            }
        }
        signed.push(made);
    }
    if args.json {
        serde_json::to_writer_pretty(&mut *out, &signed)?;
        writeln!(out)?;
    }
    Ok(())
}

/// The text of a document of entries, proved.
///
/// Errors: it cannot be read, or is none.
fn read_entries(path: &Path) -> Result<String> {
    let text = read_document(path)?;
    let limits = Limits { entries: usize::MAX, bytes: usize::MAX };
    Document::read(text.as_bytes(), &limits).with_context(|| {
        format!("{}: neither an archive (.mapd) nor entries of an overlay", path.display())
    })?;
    Ok(text)
}

/// Signs bytes of a file, beside which the signature is written; where that is.
fn write(
    args: &SignCommand,
    key: &SecretKey,
    path: &Path,
    bytes: &[u8],
    content: Option<&str>,
) -> Result<PathBuf> {
    let comment = match &args.comment {
        Some(comment) if comment.contains(['\n', '\r']) => {
            bail!("--comment: expected one line, found several")
        }
        Some(comment) => comment.clone(),
        None => {
            let file = path.file_name().unwrap_or_default().to_string_lossy();
            let seconds = crate::clock::since_epoch().as_secs();
            let content = content.map(|hash| format!("\tcontent:{hash}")).unwrap_or_default();
            format!("timestamp:{seconds}\tfile:{file}{content}")
        }
    };
    let untrusted = match content {
        Some(_) => "signature of a map archive",
        None => "signature of entries of an overlay",
    };
    let signature = minisign::sign(None, key, Cursor::new(bytes), Some(&comment), Some(untrusted))
        .with_context(|| format!("signing {}", path.display()))?;
    let to = signature_path(path);
    // A daemon that looks meanwhile sees the old one or the new one.
    draft::write(&to, signature.into_string().as_bytes())?;
    Ok(to)
}

fn secret_key(path: &Path) -> Result<SecretKey> {
    let name = path.display();
    let text = std::fs::read_to_string(path).with_context(|| format!("reading {name}"))?;
    let Some(key) = as_secret(&text) else {
        match text.lines().any(is_public) {
            true => bail!("{name} is a public key; --key takes the secret key that belongs to it"),
            false => bail!("{name} is no minisign secret key"),
        }
    };
    // Those of `minisign -G -W` have no checksum, which the crate would ask for.
    if !key.is_encrypted() {
        return Ok(key);
    }
    let password = match std::env::var(PASSWORD_VARIABLE) {
        Ok(password) => Some(password),
        // The crate asks on the terminal.
        Err(_) if std::io::stdin().is_terminal() => None,
        Err(_) => {
            bail!("{name} has a password: set {PASSWORD_VARIABLE}, or run this on a terminal")
        }
    };
    SecretKeyBox::from_string(&text)
        .and_then(|sealed| sealed.into_secret_key(password))
        .with_context(|| format!("{name}: no minisign secret key, or another password"))
}

/// What a text says as a secret key, which may be encrypted.
fn as_secret(text: &str) -> Option<SecretKey> {
    let bytes = Base64::decode_to_vec(text.lines().nth(1)?.trim(), None).ok()?;
    (bytes.len() == SECRET_BYTES).then(|| SecretKey::from_bytes(&bytes).ok())?
}

/// Whether a line is a public key: of an Ed25519 key, by its length and first letters.
fn is_public(line: &str) -> bool {
    let bytes = Base64::decode_to_vec(line.trim(), None);
    bytes.is_ok_and(|bytes| bytes.len() == PUBLIC_BYTES && bytes.starts_with(b"Ed"))
}
