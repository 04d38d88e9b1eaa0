//! Lines of a file or a pipe, in chunks of what has arrived.

use std::io::{self, BufRead, BufReader, Read};
use std::ops::Range;

/// The most lines of a chunk.
const CHUNK: usize = 8192;

/// Longer lines are cut there (and then are wrong), so that a file without line ends does not fill the memory.
pub const MAX_LINE: usize = 1 << 20;

const BUFFER: usize = 1 << 20;

/// A reader of lines.
pub struct LineReader<R> {
    source: BufReader<R>,
    /// Empty lines that have been read and that count if anything follows them.
    empty: usize,
}

/// Some lines, without their ends, in one buffer.
#[derive(Default)]
pub struct Chunk {
    text: Vec<u8>,
    lines: Vec<Range<usize>>,
}

impl Chunk {
    /// The lines in order.
    pub fn lines(&self) -> impl ExactSizeIterator<Item = &[u8]> {
        self.lines.iter().map(|line| &self.text[line.clone()])
    }

    /// Number of lines.
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    fn clear(&mut self) {
        self.text.clear();
        self.lines.clear();
    }
}

impl<R: Read> LineReader<R> {
    pub fn new(source: R) -> Self {
        Self { source: BufReader::with_capacity(BUFFER, source), empty: 0 }
    }

    /// Reads the next lines: at least one, unless the end is reached, and no more than can be had without waiting. Empty
    /// lines at the end do not count. A line longer than [`MAX_LINE`] is cut to one byte more.
    pub fn next_chunk(&mut self, chunk: &mut Chunk) -> io::Result<()> {
        chunk.clear();
        while chunk.lines.len() < CHUNK && (chunk.lines.is_empty() || self.source.buffer().contains(&b'\n')) {
            let from = chunk.text.len();
            if !self.next_line(&mut chunk.text)? {
                break;
            }
            let line = &chunk.text[from..];
            if line.len() <= MAX_LINE && line.trim_ascii().is_empty() {
                self.empty += 1;
                continue;
            }
            chunk.lines.extend(std::iter::repeat_n(from..from, std::mem::take(&mut self.empty)));
            chunk.lines.push(from..chunk.text.len());
        }
        Ok(())
    }

    /// Adds a line to `text`; false at the end of the source.
    fn next_line(&mut self, text: &mut Vec<u8>) -> io::Result<bool> {
        let from = text.len();
        let mut anything = false;
        loop {
            let available = match self.source.fill_buf() {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                available => available?,
            };
            if available.is_empty() {
                return Ok(anything);
            }
            anything = true;
            let end = available.iter().position(|byte| *byte == b'\n');
            let taken = end.unwrap_or(available.len());
            let kept = taken.min((MAX_LINE + 1).saturating_sub(text.len() - from));
            text.extend_from_slice(&available[..kept]);
            self.source.consume(taken + usize::from(end.is_some()));
            if end.is_some() {
                return Ok(true);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &[u8]) -> Vec<Vec<u8>> {
        let mut reader = LineReader::new(text);
        let (mut all, mut chunk) = (Vec::new(), Chunk::default());
        loop {
            reader.next_chunk(&mut chunk).unwrap();
            if chunk.len() == 0 {
                return all;
            }
            all.extend(chunk.lines().map(<[u8]>::to_vec));
        }
    }

    #[test]
    fn the_last_line_needs_no_end_and_empty_lines_count() {
        assert_eq!(lines(b"a\n\nb"), [b"a".to_vec(), Vec::new(), b"b".to_vec()]);
        assert_eq!(lines(b"a\n"), [b"a".to_vec()]);
        assert!(lines(b"").is_empty());
        assert_eq!(lines(b"\na\n\n \r\n"), [Vec::new(), b"a".to_vec()]);
    }

    #[test]
    fn endless_lines_are_cut() {
        let text = [vec![b'x'; 3 * MAX_LINE], b"\nshort\n".to_vec()].concat();
        let found = lines(&text);
        assert_eq!((found[0].len(), &found[1][..]), (MAX_LINE + 1, &b"short"[..]));
    }

    #[test]
    fn no_line_is_waited_for_while_another_can_be_answered() {
        /// Gives one line, then panics instead of waiting.
        struct OneLine(bool);
        impl Read for OneLine {
            fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
                assert!(!self.0, "read again before the first line was given out");
                self.0 = true;
                buffer[..2].copy_from_slice(b"a\n");
                Ok(2)
            }
        }
        let mut chunk = Chunk::default();
        LineReader::new(OneLine(false)).next_chunk(&mut chunk).unwrap();
        assert!(chunk.lines().eq([b"a"]));
    }
}
