//! `bifdiag chaos merge`: the shards of a map in one file.

use std::path::Path;

use bifdiag_chaos::Cells;
use bifdiag_schema::{ChaosMapDocument, SCHEMA_VERSION};

use super::arguments::MergeArguments;
use super::output;
use crate::cli::failure::Failure;

pub fn run(arguments: &MergeArguments) -> Result<(), Failure> {
    let target = output::format_of(arguments.out.as_deref())?;
    let mut shards = arguments.shards.iter().map(|path| shard(path)).collect::<Result<Vec<_>, _>>()?;
    shards.sort_by_key(|shard| shard.tiles);
    let Some(first) = shards.first() else {
        return Err(Failure::input("merge needs shards; name their files, such as part-*.json"));
    };
    let whole = |shard: &ChaosMapDocument| ChaosMapDocument { rows: Vec::new(), tiles: [0, 0], ..shard.clone() };
    if shards.iter().any(|shard| whole(shard) != whole(first)) {
        return Err(Failure::input(
            "the shards belong to different maps: their commands differ; name those of one map",
        ));
    }
    let cells = cells(first);
    let mut next = 0;
    for shard in &shards {
        let [from, to] = shard.tiles;
        if from != next {
            let what = if from > next { "missing" } else { "given twice" };
            let tiles = tiles(from.min(next), from.max(next));
            return Err(Failure::input(format!("{tiles} {what}; name each shard of the map once")));
        }
        next = to;
    }
    if next != cells.tiles() {
        let tiles = tiles(next, cells.tiles());
        return Err(Failure::input(format!("{tiles} missing; compute that shard too and name it")));
    }
    let map = ChaosMapDocument { tiles: [0, next], ..whole(first) };
    output::write(target, map, shards)
}

/// Which tiles are (missing, or there twice).
fn tiles(from: u64, to: u64) -> String {
    match to - from {
        1 => format!("tile {from} is"),
        _ => format!("tiles {from} to {} are", to - 1),
    }
}

/// The cells of a map.
pub fn cells(map: &ChaosMapDocument) -> Cells {
    Cells { h: map.window.h, l: map.window.l, counts: map.cells }
}

/// A map or a shard of one, as read from its file.
pub fn shard(path: &Path) -> Result<ChaosMapDocument, Failure> {
    let wrong =
        |what: String| Failure::input(format!("{}: {what}; name the .json file of a map or a shard", path.display()));
    let text = std::fs::read_to_string(path).map_err(|error| wrong(error.to_string()))?;
    let map: ChaosMapDocument = serde_json::from_str(&text).map_err(|error| wrong(error.to_string()))?;
    if map.head.schema_version == SCHEMA_VERSION {
        return Ok(map);
    }
    Err(wrong(format!("it has schema_version {}, not {SCHEMA_VERSION}", map.head.schema_version)))
}
