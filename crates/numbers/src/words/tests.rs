use super::*;
use crate::directed::Big;
use proptest::prelude::*;

const SIDES: [Toward; 2] = [Toward::Down, Toward::Up];

/// Rationals with many bits or few, near each other or far apart.
fn numbers() -> impl Strategy<Value = RBig> {
    let word = prop_oneof![3 => any::<i64>(), 1 => -3..4i64, 1 => Just(i64::MAX), 1 => Just(i64::MIN)];
    let shift = prop_oneof![2 => -70..70i32, 1 => -700..700i32];
    (prop::collection::vec(word, 1..8), shift).prop_map(|(words, shift)| {
        let whole = words.iter().fold(IBig::ZERO, |sum, word| (sum << 64) + IBig::from(*word));
        let power = IBig::ONE << shift.unsigned_abs() as usize;
        if shift < 0 { RBig::from(whole) / RBig::from(power) } else { RBig::from(whole * power) }
    })
}

/// The number beside this one in a direction.
fn beside<const N: usize>(x: &Words<N>, toward: Toward) -> RBig {
    let grows = (toward == Toward::Up) == (x.sign == Sign::Positive);
    // Towards 0 the numbers lie twice as close below a power of two.
    let is_power = x.m[N - 1] == 1 << 63 && x.m[..N - 1].iter().all(|word| *word == 0);
    let last =
        Words::<N> { sign: Sign::Positive, exponent: x.exponent - i64::from(is_power && !grows), ..Words::<N>::ZERO };
    let unit = Words::<N> { m: std::array::from_fn(|k| u64::from(k == 0)), ..last }.to_rational();
    if toward == Toward::Up { x.to_rational() + unit } else { x.to_rational() - unit }
}

/// It lies on the side that was asked for, and no other number lies between; `order` compares a rational with the exact
/// result.
fn nearest<const N: usize>(
    x: Option<Words<N>>,
    toward: Toward,
    order: impl Fn(&RBig) -> Ordering,
) -> Result<(), TestCaseError> {
    let x = x.unwrap();
    let at = order(&x.to_rational());
    let (outward, inward) = match toward {
        Toward::Down => (Ordering::Less, Toward::Up),
        Toward::Up => (Ordering::Greater, Toward::Down),
    };
    if x.sign == Sign::Zero {
        prop_assert_eq!(at, Ordering::Equal);
    } else if at != Ordering::Equal {
        prop_assert_eq!(at, outward);
        prop_assert_eq!(order(&beside(&x, inward)), outward.reverse(), "{:?}", x);
    }
    Ok(())
}

fn rounds<const N: usize>(p: &RBig, q: &RBig) -> Result<(), TestCaseError> {
    for toward in SIDES {
        let [a, b] = [p, q].map(|x| Words::<N>::rational(x, (), toward).unwrap());
        nearest(Some(a), toward, |x| x.cmp(p))?;
        let [p, q] = [a, b].map(|x| x.to_rational());
        for side in SIDES {
            nearest(a.plus(&b, (), side), side, |x| x.cmp(&(&p + &q)))?;
            nearest(a.plus(&b.negated(), (), side), side, |x| x.cmp(&(&p - &q)))?;
            nearest(a.times(&b, (), side), side, |x| x.cmp(&(&p * &q)))?;
            if b.sign == Sign::Zero {
                prop_assert!(a.over(&b, (), side).is_none());
            } else {
                nearest(a.over(&b, (), side), side, |x| x.cmp(&(&p / &q)))?;
            }
            match a.root((), side) {
                None => prop_assert!(p < RBig::ZERO),
                root => nearest(root, side, |x| if *x < RBig::ZERO { Ordering::Less } else { (x * x).cmp(&p) })?,
            }
        }
        prop_assert_eq!(a.cmp(&b), p.cmp(&q));
        let big = Big::rational(&p, 64 * N, toward).unwrap();
        prop_assert_eq!((big.to_rational(), big.to_double()), (p, a.to_double()));
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn every_operation_gives_the_nearest_number_on_its_side(p in numbers(), q in numbers(), near in any::<bool>()) {
        let q = if near { &p + q / RBig::from(IBig::ONE << 900) } else { q };
        rounds::<2>(&p, &q)?;
        rounds::<3>(&p, &q)?;
        rounds::<6>(&p, &q)?;
    }

    #[test]
    fn doubles_are_exact(value in any::<f64>()) {
        let found = Words::<2>::double(value, ());
        prop_assert_eq!(found.is_some(), value.is_finite());
        if let Some(found) = found {
            prop_assert_eq!(found.to_rational(), RBig::try_from(value).unwrap());
            prop_assert_eq!(found.to_double(), value);
        }
    }
}

#[test]
fn exponents_without_end_are_no_numbers() {
    let mut x = Words::<2>::double(2.0, ()).unwrap();
    while let Some(square) = x.times(&x, (), Toward::Up) {
        x = square;
    }
    assert!(x.exponent > 1 << 30);
    assert_eq!([x, x.negated()].map(|x| x.to_double()), [f64::MAX, f64::NEG_INFINITY]);
    let tiny = Words::<2>::double(1.0, ()).unwrap().over(&x.root((), Toward::Down).unwrap(), (), Toward::Up).unwrap();
    assert_eq!([tiny, tiny.negated()].map(|x| x.to_double()), [0.0, -5e-324]);
}
