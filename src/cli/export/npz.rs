//! NumPy's NPZ: a ZIP archive, not compressed, with an array in the NPY format 1.0 for each column.
//!
//! The same table gives the same bytes: entries carry the first date that ZIP knows. Bytes are not compressed
//! because the low bits of chaotic motion are random.

use std::io::{Cursor, Write};

use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use super::columns::{Columns, Values};
use super::error::ExportError;

/// Entries larger than this need ZIP's 64-bit fields.
const LARGE: usize = 1 << 31;

/// An archive in the making.
pub struct Archive(ZipWriter<Cursor<Vec<u8>>>);

impl Archive {
    /// Nothing yet.
    pub fn new() -> Self {
        Self(ZipWriter::new(Cursor::new(Vec::new())))
    }

    /// Adds an array; `kind` is NumPy's name of its type, `shape` as Python writes it.
    fn add(&mut self, name: &str, kind: &str, shape: &str, data: &[u8]) -> Result<(), ZipError> {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(DateTime::DEFAULT)
            .unix_permissions(0o644)
            .large_file(data.len() > LARGE);
        self.0.start_file(format!("{name}.npy"), options)?;
        self.0.write_all(&header(kind, shape))?;
        self.0.write_all(data)?;
        Ok(())
    }

    /// Adds a column.
    fn column(&mut self, name: &str, values: &Values) -> Result<(), ZipError> {
        let (rows, width) = (values.len(), values.parts().len());
        let shape = if width == 1 { format!("({rows},)") } else { format!("({rows}, {width})") };
        match values {
            Values::Int8(values) => {
                self.add(name, "|i1", &shape, &values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>())
            }
            Values::Int32(values) => self.integers(name, &shape, values),
            Values::Words { places, .. } => self.column(name, places),
            Values::Float { values, .. } => {
                self.add(name, "<f8", &shape, &values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>())
            }
        }
    }

    /// Adds integers in rows of equal length.
    pub fn matrix(&mut self, name: &str, rows: usize, values: &[i32]) -> Result<(), ZipError> {
        self.integers(name, &format!("({rows}, {})", values.len() / rows.max(1)), values)
    }

    fn integers(&mut self, name: &str, shape: &str, values: &[i32]) -> Result<(), ZipError> {
        let mut data = Vec::with_capacity(size_of_val(values));
        for value in values {
            data.extend_from_slice(&value.to_le_bytes());
        }
        self.add(name, "<i4", shape, &data)
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

    /// The whole archive.
    pub fn bytes(self) -> Result<Vec<u8>, ZipError> {
        Ok(self.0.finish()?.into_inner())
    }
}

/// A table and what it means as an archive.
pub fn archive(table: &Columns) -> Result<Vec<u8>, ExportError> {
    let mut archive = Archive::new();
    for column in &table.columns {
        archive.column(column.name, &column.values)?;
    }
    archive.text("meta", &table.meta)?;
    Ok(archive.bytes()?)
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
    use crate::cli::export::columns::Column;

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
        let bytes = archive(&table()).unwrap();
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
        assert_eq!(archive(&table()).unwrap(), archive(&table()).unwrap());
    }
}
