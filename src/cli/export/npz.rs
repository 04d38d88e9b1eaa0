//! NumPy's NPZ: a ZIP archive, not compressed, with an array in the NPY format 1.0 for each column.
//!
//! The same table gives the same bytes: entries carry the first date that ZIP knows. Bytes are not compressed
//! because the low bits of chaotic motion are random.

use std::io::{Cursor, Seek, Write};

use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use super::columns::{Pieces, Values};
use crate::cli::failure::Failure;

/// Entries larger than this need ZIP's 64-bit fields.
const LARGE: usize = 1 << 31;

/// An archive in the making.
pub struct Archive<W: Write + Seek = Cursor<Vec<u8>>>(ZipWriter<W>);

impl Archive {
    /// Nothing yet, in memory.
    pub fn new() -> Self {
        Self::onto(Cursor::new(Vec::new()))
    }

    /// The whole archive.
    pub fn bytes(self) -> Result<Vec<u8>, ZipError> {
        Ok(self.0.finish()?.into_inner())
    }
}

impl<W: Write + Seek> Archive<W> {
    /// Nothing yet.
    fn onto(out: W) -> Self {
        Self(ZipWriter::new(out))
    }

    /// Adds an array; `kind` is NumPy's name of its type, `shape` as Python writes it.
    fn add(&mut self, name: &str, kind: &str, shape: &str, data: &[u8]) -> Result<(), ZipError> {
        self.begin(name, kind, shape, data.len())?;
        self.0.write_all(data)?;
        Ok(())
    }

    /// Begins an array of `bytes` bytes, which are to follow.
    fn begin(&mut self, name: &str, kind: &str, shape: &str, bytes: usize) -> Result<(), ZipError> {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(DateTime::DEFAULT)
            .unix_permissions(0o644)
            .large_file(bytes > LARGE);
        self.0.start_file(format!("{name}.npy"), options)?;
        self.0.write_all(&header(kind, shape))?;
        Ok(())
    }

    /// Begins a column of `rows` rows, which are to follow.
    fn begin_column(&mut self, name: &str, values: &Values, rows: usize) -> Result<(), ZipError> {
        let width = values.parts().len();
        let shape = if width == 1 { format!("({rows},)") } else { format!("({rows}, {width})") };
        let kind = match values.numbers() {
            Values::Int8(_) => "|i1",
            Values::Int32(_) => "<i4",
            Values::Words { .. } | Values::Float { .. } => "<f8",
        };
        self.begin(name, kind, &shape, rows * values.row_bytes())
    }

    /// Adds a column.
    fn column(&mut self, name: &str, values: &Values) -> Result<(), ZipError> {
        self.begin_column(name, values, values.len())?;
        self.0.write_all(&values.bytes())?;
        Ok(())
    }

    /// Adds integers in rows of equal length.
    pub fn matrix(&mut self, name: &str, rows: usize, values: &[i32]) -> Result<(), ZipError> {
        let shape = format!("({rows}, {})", values.len() / rows.max(1));
        self.add(name, "<i4", &shape, &Values::Int32(values.to_vec()).bytes())
    }

    /// Adds doubles.
    pub fn floats(&mut self, name: &str, values: &[f64]) -> Result<(), ZipError> {
        self.column(name, &Values::floats(values.iter().copied()))
    }

    /// Adds strings.
    pub fn texts(&mut self, name: &str, texts: &[String]) -> Result<(), ZipError> {
        let width = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
        let padded =
            |text: &String| text.chars().map(u32::from).chain(std::iter::repeat(0)).take(width).collect::<Vec<_>>();
        let data: Vec<u8> = texts.iter().flat_map(padded).flat_map(u32::to_le_bytes).collect();
        self.add(name, &format!("<U{width}"), &format!("({},)", texts.len()), &data)
    }

    /// Adds a string as an array without axes: `str(data["meta"])` in Python.
    pub fn text(&mut self, name: &str, text: &str) -> Result<(), ZipError> {
        let data: Vec<u8> = text.chars().flat_map(|c| u32::from(c).to_le_bytes()).collect();
        self.add(name, &format!("<U{}", text.chars().count()), "()", &data)
    }
}

/// Writes a table and what it means as an archive.
pub fn write(table: &mut impl Pieces, out: impl Write + Seek) -> Result<(), Failure> {
    let mut archive = Archive::onto(out);
    let rows = table.rows();
    for (number, column) in table.columns().iter().enumerate() {
        archive.begin_column(column.name, &column.values, rows)?;
        table.column(number, &mut |bytes| archive.0.write_all(bytes)).map_err(ZipError::from)?;
    }
    archive.text("meta", table.meta())?;
    archive.0.finish()?.flush().map_err(ZipError::from)?;
    Ok(())
}

/// Magic, version, and the dictionary padded so that the data begin at a multiple of 64 bytes.
fn header(kind: &str, shape: &str) -> Vec<u8> {
    const ALIGNMENT: usize = 64;
    const PREFIX: usize = 10;
    let mut dictionary = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    let unpadded = PREFIX + dictionary.len() + 1;
    dictionary.push_str(&" ".repeat(unpadded.next_multiple_of(ALIGNMENT) - unpadded));
    dictionary.push('\n');
    let length = u16::try_from(dictionary.len()).expect("a header is a few hundred bytes long");
    let mut out = b"\x93NUMPY\x01\x00".to_vec();
    out.extend(length.to_le_bytes());
    out.extend(dictionary.as_bytes());
    out
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use super::*;
    use crate::cli::export::columns::{Column, Columns};

    fn archive(table: &Columns) -> Vec<u8> {
        let mut out = Cursor::new(Vec::new());
        write(&mut &*table, &mut out).unwrap();
        out.into_inner()
    }

    fn table() -> Columns {
        Columns {
            columns: vec![
                Column { name: "orbit", values: Values::Int32(vec![0, -1]) },
                Column { name: "gamma", values: Values::vectors([[0.1, 0.2, 0.3], [1.0, 2.0, 4.0]].into_iter()) },
                Column { name: "sheet", values: Values::Int8(vec![1, -1]) },
            ],
            meta: "{\"ϑ\": 1}".to_owned(),
        }
    }

    #[test]
    fn arrays_are_where_numpy_looks_for_them() {
        let bytes = archive(&table());
        let mut zip = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
        let mut entry = |name: &str| {
            let mut bytes = Vec::new();
            zip.by_name(name).unwrap().read_to_end(&mut bytes).unwrap();
            let data = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
            assert_eq!((&bytes[..8], data % 64), (&b"\x93NUMPY\x01\x00"[..], 0));
            (String::from_utf8(bytes[10..data].to_vec()).unwrap(), bytes[data..].to_vec())
        };
        let (head, data) = entry("gamma.npy");
        assert!(head.starts_with("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }"), "{head}");
        assert_eq!((data.len(), &data[8..16]), (48, &0.2_f64.to_le_bytes()[..]));
        let (head, data) = entry("orbit.npy");
        assert!(head.contains("'<i4'") && head.contains("(2,)"), "{head}");
        assert_eq!(data, [0, 0, 0, 0, 255, 255, 255, 255]);
        assert_eq!(entry("sheet.npy").1, [1, 255]);
        let (head, data) = entry("meta.npy");
        assert!(head.contains("'<U8'") && head.contains("'shape': ()"), "{head}");
        assert_eq!((data.len(), &data[8..12]), (32, &0x3d1_u32.to_le_bytes()[..]));
    }

    #[test]
    fn the_same_table_gives_the_same_bytes() {
        assert_eq!(archive(&table()), archive(&table()));
    }
}
