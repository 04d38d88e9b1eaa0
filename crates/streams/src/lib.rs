//! Whether standard input and output were open when the process began.
//!
//! Rust opens `/dev/null` in the place of a standard stream that is closed (`>&-`), before `main`: what is written there
//! is lost without an error, and what is read there looks like an empty input. Only code that runs before Rust's own start can see it.

/// True if standard input was closed when the process began; false where this is not known.
#[must_use]
pub fn stdin_was_closed() -> bool {
    #[cfg(any(target_os = "linux", target_os = "android", target_os = "freebsd", target_vendor = "apple"))]
    return start::NO_INPUT.load(std::sync::atomic::Ordering::Relaxed);
    #[cfg(not(any(target_os = "linux", target_os = "android", target_os = "freebsd", target_vendor = "apple")))]
    false
}

/// True if standard output was closed when the process began; false where this is not known.
#[must_use]
pub fn stdout_was_closed() -> bool {
    #[cfg(any(target_os = "linux", target_os = "android", target_os = "freebsd", target_vendor = "apple"))]
    return start::NO_OUTPUT.load(std::sync::atomic::Ordering::Relaxed);
    #[cfg(not(any(target_os = "linux", target_os = "android", target_os = "freebsd", target_vendor = "apple")))]
    false
}

#[cfg(any(target_os = "linux", target_os = "android", target_os = "freebsd", target_vendor = "apple"))]
mod start {
    use std::sync::atomic::{AtomicBool, Ordering};

    pub static NO_INPUT: AtomicBool = AtomicBool::new(false);
    pub static NO_OUTPUT: AtomicBool = AtomicBool::new(false);

    /// System calls and stores: nothing that needs Rust's start.
    extern "C" fn look() {
        NO_INPUT.store(rustix::io::fcntl_getfd(rustix::stdio::stdin()).is_err(), Ordering::Relaxed);
        NO_OUTPUT.store(rustix::io::fcntl_getfd(rustix::stdio::stdout()).is_err(), Ordering::Relaxed);
    }

    /// The loader calls what stands in this section before `main`.
    #[used]
    #[cfg_attr(target_vendor = "apple", unsafe(link_section = "__DATA,__mod_init_func,mod_init_funcs"))]
    #[cfg_attr(not(target_vendor = "apple"), unsafe(link_section = ".init_array"))]
    #[expect(unsafe_code, reason = "the section holds addresses of functions without arguments, as the loader expects")]
    static LOOK: extern "C" fn() = look;
}
