//! Runs a program and stops it at each of its system calls, so that it can be killed at any one of them, or something be
//! done while it waits there. What `strace -f -e inject=…` does, but exact where a program has several threads: a moment is
//! the n-th call of the n-th thread, before or after the kernel has carried it out.

use nix::errno::Errno;
use nix::sys::ptrace::{self, Options};
use nix::sys::signal::{Signal, kill};
use nix::sys::wait::{WaitPidFlag, WaitStatus, waitpid};
use nix::unistd::{Pid, gettid};
use std::collections::HashMap;
use std::fmt;
use std::io::{self, Write};
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::process::{Command, ExitStatus, Stdio};
use syscalls::Sysno;

/// `op` of `PTRACE_GET_SYSCALL_INFO` where a call begins.
const SYSCALL_BEGINS: u8 = 1;
/// `op` of `PTRACE_GET_SYSCALL_INFO` where a call ends.
const SYSCALL_ENDS: u8 = 2;

/// Which side of a system call.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// The kernel has not begun: a process that is killed here never made the call.
    Before,
    /// The kernel has done it, and the program does not know yet.
    After,
}

/// A moment in the life of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Moment {
    /// Threads in the order they were made; 0 is the first.
    pub thread: usize,
    /// Calls of this thread, counted from 1, since the program was executed.
    pub call: usize,
    /// Before or after it.
    pub side: Side,
    /// The system call.
    pub name: Sysno,
}

impl fmt::Display for Moment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let side = if self.side == Side::Before { "before" } else { "after" };
        write!(f, "{side} {} (call {} of thread {})", self.name, self.call, self.thread)
    }
}

/// What becomes of the program at a moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Then {
    /// It goes on.
    Continue,
    /// SIGKILL, here.
    Kill,
}

struct Thread {
    number: usize,
    calls: usize,
}

/// A program that waits to be executed under the tracer's eyes.
pub struct Traced {
    leader: Pid,
    threads: HashMap<Pid, Thread>,
    made: usize,
    executed: bool,
}

impl Traced {
    /// Starts `program`, which runs once [`Traced::run`] is called. `input` is its standard input; its
    /// output goes nowhere. Returns its standard error, if that is piped.
    ///
    /// Errors: it cannot be started; tracing is not permitted.
    pub fn start(
        program: &Command,
        input: &str,
        stderr: Stdio,
    ) -> io::Result<(Self, Option<std::process::ChildStderr>)> {
        // The shell waits until the tracer has it, then becomes the program.
        let mut shell = Command::new("/bin/sh");
        shell.args(["-c", "read go && exec \"$@\"", "sh"]);
        shell.arg(program.get_program()).args(program.get_args());
        for (name, value) in program.get_envs() {
            match value {
                Some(value) => shell.env(name, value),
                None => shell.env_remove(name),
            };
        }
        // A group of its own, so that waiting for it reaps no other child.
        shell.process_group(0).stdin(Stdio::piped()).stdout(Stdio::null()).stderr(stderr);
        let mut child = shell.spawn()?;
        let leader = Pid::from_raw(child.id() as i32);
        let options = Options::PTRACE_O_TRACESYSGOOD
            | Options::PTRACE_O_TRACEEXEC
            | Options::PTRACE_O_TRACECLONE
            | Options::PTRACE_O_TRACEFORK
            | Options::PTRACE_O_TRACEVFORK
            | Options::PTRACE_O_EXITKILL;
        if let Err(error) = ptrace::seize(leader, options) {
            child.kill()?;
            child.wait()?;
            return Err(error.into());
        }
        if let Some(mut stdin) = child.stdin.take() {
            write!(stdin, "go\n{input}")?;
        }
        let threads = HashMap::from([(leader, Thread { number: 0, calls: 0 })]);
        Ok((Self { leader, threads, made: 1, executed: false }, child.stderr.take()))
    }

    /// Its process id.
    pub fn pid(&self) -> Pid {
        self.leader
    }

    /// Runs it to its end, asking `at` at every moment. In the thread that started it, as the kernel demands.
    ///
    /// Errors: what the system says.
    pub fn run(mut self, mut at: impl FnMut(&Moment) -> Then) -> io::Result<ExitStatus> {
        let group = Pid::from_raw(-self.leader.as_raw());
        loop {
            let status = match waitpid(group, Some(WaitPidFlag::__WALL)) {
                Err(Errno::EINTR) => continue,
                other => other?,
            };
            match status {
                WaitStatus::Exited(pid, code) if pid == self.leader => {
                    self.end_the_rest();
                    return Ok(ExitStatus::from_raw(code << 8));
                }
                WaitStatus::Signaled(pid, signal, _) if pid == self.leader => {
                    self.end_the_rest();
                    return Ok(ExitStatus::from_raw(signal as i32));
                }
                WaitStatus::Exited(pid, _) | WaitStatus::Signaled(pid, ..) => {
                    self.threads.remove(&pid);
                }
                WaitStatus::PtraceSyscall(pid) => {
                    let then = self.moment(pid)?.map_or(Then::Continue, |moment| at(&moment));
                    if then == Then::Kill {
                        kill(self.leader, Signal::SIGKILL)?;
                    }
                    go_on(pid, None)?;
                }
                WaitStatus::PtraceEvent(pid, _, _) => {
                    self.executed |= !self.executed && self.has_executed()?;
                    self.number_of(pid);
                    go_on(pid, None)?;
                }
                WaitStatus::Stopped(pid, signal) => go_on(pid, Some(signal))?,
                _ => {}
            }
        }
    }

    /// Ends children that outlive the program: they would wait for the tracer for ever.
    fn end_the_rest(&mut self) {
        // The thread that traces, as the kernel demands, not its process.
        let us = format!("TracerPid:\t{}", gettid());
        for pid in self.threads.keys().filter(|pid| **pid != self.leader) {
            let status = std::fs::read_to_string(format!("/proc/{pid}/status"));
            if status.is_ok_and(|status| status.lines().any(|line| line == us)) {
                // Fails only if it has just ended.
                let _ = kill(*pid, Signal::SIGKILL);
            }
        }
        let group = Pid::from_raw(-self.leader.as_raw());
        loop {
            match waitpid(group, Some(WaitPidFlag::__WALL)) {
                Ok(WaitStatus::Exited(..) | WaitStatus::Signaled(..)) | Err(Errno::EINTR) => {}
                // One that has just been made, and stops for the first time.
                Ok(status) => {
                    let _ = status.pid().map(|pid| kill(pid, Signal::SIGKILL));
                }
                Err(_) => return,
            }
        }
    }

    fn has_executed(&self) -> io::Result<bool> {
        let name = std::fs::read_link(format!("/proc/{}/exe", self.leader))?;
        Ok(name != std::fs::canonicalize("/bin/sh")?)
    }

    fn number_of(&mut self, pid: Pid) -> &mut Thread {
        let made = &mut self.made;
        self.threads.entry(pid).or_insert_with(|| {
            *made += 1;
            Thread { number: *made - 1, calls: 0 }
        })
    }

    fn moment(&mut self, pid: Pid) -> io::Result<Option<Moment>> {
        // A thread that another one's end takes along has no state any more.
        let (Ok(info), Ok(registers)) = (ptrace::syscall_info(pid), ptrace::getregs(pid)) else {
            return Ok(None);
        };
        #[cfg(target_arch = "x86_64")]
        let number = registers.orig_rax as usize;
        #[cfg(target_arch = "aarch64")]
        let number = registers.regs[8] as usize;
        let side = match info.op {
            SYSCALL_BEGINS => Side::Before,
            SYSCALL_ENDS => Side::After,
            _ => return Ok(None),
        };
        let Some(name) = Sysno::new(number) else { return Ok(None) };
        if !self.executed {
            return Ok(None);
        }
        let thread = self.number_of(pid);
        // The program's first stop is the end of the `execve` that began in the shell.
        if side == Side::Before {
            thread.calls += 1;
        }
        Ok(Some(Moment { thread: thread.number, call: thread.calls, side, name }))
    }
}

/// Lets a thread run to its next stop. One that has been killed meanwhile is gone.
fn go_on(pid: Pid, signal: Option<Signal>) -> io::Result<()> {
    match ptrace::syscall(pid, signal) {
        Err(Errno::ESRCH) => Ok(()),
        other => Ok(other?),
    }
}
