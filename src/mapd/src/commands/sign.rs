//! `mapd sign`: signatures in minisign's format, beside the archive.

use crate::exit::Exit;
use anyhow::{Context, Result, bail};
use clap::Args;
use ct_codecs::{Base64, Decoder};
use mapd_archive::verify;
use mapd_client::{Snapshot, signature_path};
use minisign::{SecretKey, SecretKeyBox};
use serde::Serialize;
use std::io::{Cursor, IsTerminal, Write};
use std::path::PathBuf;

/// Environment variable of the secret key's password, for where nobody can type it.
const PASSWORD_VARIABLE: &str = "MAPD_SIGN_PASSWORD";

/// What to sign.
#[derive(Args)]
pub(crate) struct SignCommand {
    /// Archives (.mapd)
    #[arg(required = true)]
    archives: Vec<PathBuf>,
    /// Secret key, as `minisign -G` writes it; asks for the password, or takes MAPD_SIGN_PASSWORD
    #[arg(long, value_name = "SECRET")]
    key: PathBuf,
    /// Print JSON: a list of what was signed
    #[arg(long)]
    json: bool,
    /// Comment that is signed too [default: time, name of the archive and hash of its content]
    #[arg(long, value_name = "TEXT")]
    comment: Option<String>,
}

impl SignCommand {
    /// Signs archives.
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
    archive: PathBuf,
    signature: PathBuf,
    content_hash: String,
}

/// Signs archives; each is proved first, for nobody should sign what nobody can read.
///
/// Errors: the key cannot be had; an archive cannot be read or does not prove; its signature cannot be written.
fn sign(args: &SignCommand, out: &mut dyn Write) -> Result<()> {
    let key = secret_key(&args.key)?;
    let mut signed = Vec::new();
    for path in &args.archives {
        let snapshot = Snapshot::open(path)?;
        let name = path.display();
        let header = verify(snapshot.bytes()).with_context(|| name.to_string())?.header;
        let content = crate::report::hex(&header.content_hash);
        let comment = match &args.comment {
            Some(comment) if comment.contains(['\n', '\r']) => {
                bail!("--comment: expected one line, found several")
            }
            Some(comment) => comment.clone(),
            None => {
                let file = path.file_name().unwrap_or_default().to_string_lossy();
                let seconds = crate::clock::since_epoch().as_secs();
                format!("timestamp:{seconds}\tfile:{file}\tcontent:{content}")
            }
        };
        let signature = minisign::sign(
            None,
            &key,
            Cursor::new(snapshot.bytes()),
            Some(&comment),
            Some("signature of a map archive"),
        )
        .with_context(|| format!("signing {name}"))?;
        let to = signature_path(path);
        // Written anew and renamed, so that a daemon that looks meanwhile sees the old one or the new one.
        let new = to.with_extension(format!("minisig.{}.tmp", std::process::id()));
        std::fs::write(&new, signature.into_string())
            .and_then(|()| std::fs::rename(&new, &to))
            .with_context(|| format!("writing {}", to.display()))?;
        if !args.json {
            writeln!(out, "{}: content {content}", to.display())?;
        }
        signed.push(Signed { archive: path.clone(), signature: to, content_hash: content });
    }
    if args.json {
        serde_json::to_writer_pretty(&mut *out, &signed)?;
        writeln!(out)?;
    }
    Ok(())
}

fn secret_key(path: &std::path::Path) -> Result<SecretKey> {
    let name = path.display();
    let text = std::fs::read_to_string(path).with_context(|| format!("reading {name}"))?;
    if let Some(key) = without_password(&text) {
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

/// A key that needs no password. Those of `minisign -G -W` have no checksum, which the crate would ask for.
fn without_password(text: &str) -> Option<SecretKey> {
    let bytes = Base64::decode_to_vec(text.lines().nth(1)?.trim(), None).ok()?;
    SecretKey::from_bytes(&bytes).ok().filter(|key| !key.is_encrypted())
}
