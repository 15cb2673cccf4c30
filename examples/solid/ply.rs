//! Vertices and triangles of a PLY file, ascii or binary (little-endian).

use super::solids::Mesh;

pub fn read(path: &str) -> Result<Mesh, String> {
    let bytes = std::fs::read(path).map_err(|problem| problem.to_string())?;
    const END: &[u8] = b"end_header\n";
    let end = bytes.windows(END.len()).position(|window| window == END).ok_or("no header")? + END.len();
    let header = String::from_utf8_lossy(&bytes[..end]).into_owned();
    let is_ascii = header.contains("format ascii");
    let mut elements: Vec<(String, usize)> = Vec::new();
    // By element, the words of each.
    let mut properties: Vec<Vec<Vec<String>>> = Vec::new();
    for line in header.lines() {
        let words: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
        match words.first().map(String::as_str) {
            Some("element") => {
                elements.push((words[1].clone(), words[2].parse().map_err(|_| "a broken count")?));
                properties.push(Vec::new());
            }
            Some("property") => properties.last_mut().ok_or("a property of nothing")?.push(words[1..].to_vec()),
            _ => {}
        }
    }
    let mut source = if is_ascii {
        let text = String::from_utf8_lossy(&bytes[end..]).into_owned();
        Source::Words(text.split_whitespace().map(str::to_owned).collect::<Vec<_>>().into_iter())
    } else {
        Source::Bytes(&bytes[end..])
    };
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for ((name, count), properties) in elements.iter().zip(&properties) {
        for _ in 0..*count {
            let mut point = [0.0; 3];
            for property in properties {
                if property[0] == "list" {
                    let length = source.next(&property[1])? as usize;
                    let corners: Vec<u32> =
                        (0..length).map(|_| source.next(&property[2]).map(|x| x as u32)).collect::<Result<_, _>>()?;
                    if name == "face" {
                        triangles.extend((2..corners.len()).map(|k| [corners[0], corners[k - 1], corners[k]]));
                    }
                } else {
                    let value = source.next(&property[0])?;
                    if let Some(axis) = ["x", "y", "z"].iter().position(|axis| property[1] == *axis) {
                        point[axis] = value;
                    }
                }
            }
            if name == "vertex" {
                positions.push(point);
            }
        }
    }
    Ok((positions, triangles))
}

enum Source<'a> {
    Words(std::vec::IntoIter<String>),
    Bytes(&'a [u8]),
}

impl Source<'_> {
    fn next(&mut self, kind: &str) -> Result<f64, String> {
        match self {
            Self::Words(words) => words.next().ok_or("too short")?.parse().map_err(|_| "a broken number".into()),
            Self::Bytes(bytes) => {
                let mut take = |count: usize| {
                    let (taken, rest) = bytes.split_at_checked(count).ok_or("too short")?;
                    *bytes = rest;
                    Ok::<_, String>(taken)
                };
                macro_rules! number {
                    ($type:ty) => {
                        <$type>::from_le_bytes(take(size_of::<$type>())?.try_into().expect("as many bytes")) as f64
                    };
                }
                Ok(match kind {
                    "char" | "int8" => number!(i8),
                    "uchar" | "uint8" => number!(u8),
                    "short" | "int16" => number!(i16),
                    "ushort" | "uint16" => number!(u16),
                    "int" | "int32" => number!(i32),
                    "uint" | "uint32" => number!(u32),
                    "float" | "float32" => number!(f32),
                    "double" | "float64" => number!(f64),
                    other => return Err(format!("the type {other}")),
                })
            }
        }
    }
}
