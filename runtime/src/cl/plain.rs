//! The bulk of every CL file: lines that hold a GOTO and nothing else.

use crate::cl::number::plain_decimal;
use crate::vector::Vec3;

/// A line that is a GOTO of three or six plain numbers: tip, axis, and how many bytes the line takes. `None` for anything
/// else, which need not be wrong.
#[inline]
pub(super) fn plain_goto(lines: &[u8]) -> Option<(Vec3, Option<Vec3>, usize)> {
    let mut rest = lines.strip_prefix(b"GOTO/")?;
    let mut numbers = [0.0; 6];
    let mut count = 0;
    loop {
        let (value, behind) = plain_decimal(rest)?;
        *numbers.get_mut(count)? = value;
        count += 1;
        rest = match behind {
            [b',', behind @ ..] => behind,
            [b'\n', behind @ ..] | [b'\r', b'\n', behind @ ..] => {
                rest = behind;
                break;
            }
            _ => return None,
        };
    }
    let length = lines.len() - rest.len();
    let [x, y, z, i, j, k] = numbers;
    match count {
        3 => Some(([x, y, z], None, length)),
        6 => Some(([x, y, z], Some([i, j, k]), length)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_or_six_numbers_to_the_end_of_the_line() {
        assert_eq!(plain_goto(b"GOTO/1.5,-2,.5\nGOTO/"), Some(([1.5, -2.0, 0.5], None, 15)));
        let six = Some(([1.0, 2.0, 3.0], Some([0.0, 0.0, 1.0]), 25));
        assert_eq!(plain_goto(b"GOTO/1.,2.,3.,0.,0.0,1.\r\n"), six);
    }

    #[test]
    fn everything_else_wants_a_closer_look() {
        for line in [
            "GOTO/1,2\n",
            "GOTO/1,2,3,4\n",
            "GOTO/1,2,3,0,0,1,1\n",
            "GOTO/1,2,3",
            "GOTO/1,2,3 $$ contact\n",
            "GOTO/1,2,3E1\n",
            "GOTO/1, 2,3\n",
            "GOTO/1,2,x\n",
            "GODLTA/1,2,3\n",
            "GOTO/",
        ] {
            assert_eq!(plain_goto(line.as_bytes()), None, "{line}");
        }
    }
}
