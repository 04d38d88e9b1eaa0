use super::*;
use dashu_int::IBig;
use proptest::prelude::*;

type Small = Ball<3>;

fn power(exponent: isize) -> RBig {
    let size = RBig::from(IBig::ONE << exponent.unsigned_abs());
    if exponent < 0 { RBig::ONE / size } else { size }
}

fn size(x: RBig) -> RBig {
    if x < RBig::ZERO { -x } else { x }
}

/// The middle and the largest distance from it.
fn exact(ball: &Small) -> [RBig; 2] {
    let mantissa = ball.mantissa.iter().rev().fold(RBig::ZERO, |sum, &word| sum * power(WORD) + RBig::from(word));
    let signed = if ball.is_negative { -mantissa } else { mantissa };
    let error = RBig::try_from(ball.error).expect("a finite error");
    [signed * power(ball.exponent), error * power(ball.exponent + Small::HALF)]
}

fn holds(ball: &Small, x: &RBig) -> bool {
    let [middle, error] = exact(ball);
    let is_normal = if ball.mantissa == [0; 3] {
        ball.error == 0.0 || ball.error >= Small::WIDE
    } else {
        ball.mantissa[2] >> 63 == 1 && ball.error < Small::WIDE
    };
    is_normal && size(middle - x) <= error
}

/// Ordinary rationals, zero and whole numbers, and numbers of very different sizes.
fn rationals() -> impl Strategy<Value = RBig> {
    let ratio = |p: i64, q: u32| RBig::from_parts(p.into(), q.into());
    prop_oneof![
        (-9999i64..9999, 1u32..999).prop_map(move |(p, q)| ratio(p, q)),
        (-3i64..=3).prop_map(RBig::from),
        (any::<i64>(), 1u32..u32::MAX, -400isize..400).prop_map(move |(p, q, exponent)| ratio(p, q) * power(exponent)),
    ]
}

/// A ball, some wide or of zero alone, and a member of it.
fn balls() -> impl Strategy<Value = (Small, RBig)> {
    let wide = (rationals(), rationals(), 0u32..=8).prop_map(|(p, q, part)| {
        let (lo, hi) = if p <= q { (p, q) } else { (q, p) };
        let x = &lo + (&hi - &lo) * RBig::from(part) / RBig::from(8);
        (Small::between(&lo, &hi), x)
    });
    let near = (rationals(), -250isize..-20, -1i32..=1).prop_map(|(x, exponent, side)| {
        let reach = size(x.clone()) * power(exponent);
        (Small::between(&(&x - &reach), &(&x + &reach)), x + reach * RBig::from(side))
    });
    prop_oneof![rationals().prop_map(|x| (Small::of(&x), x)), near, wide]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn operations_hold_every_result((a, x) in balls(), (b, y) in balls()) {
        prop_assert!(holds(&a, &x));
        prop_assert!(holds(&(&a + &b), &(&x + &y)));
        prop_assert!(holds(&(&a - &b), &(&x - &y)));
        prop_assert!(holds(&(&a * &b), &(&x * &y)));
        prop_assert!(holds(&-&a, &-&x));
        prop_assert!(holds(&a.half(), &(&x / RBig::from(2))));
        // Where what was added is taken away again.
        prop_assert!(holds(&(&(&a + &b) - &b), &x));
        if let Some(quotient) = a.over(&b) {
            prop_assert!(holds(&quotient, &(&x / &y)));
        }
    }

    #[test]
    fn roots_hold_every_root((a, x) in balls()) {
        prop_assert!(holds(&a.square().root().unwrap(), &size(x)));
    }

    #[test]
    fn signs_are_claimed_only_when_certain((a, x) in balls(), (b, y) in balls()) {
        for (ball, value) in [(&a, &x), (&(&a - &b), &(&x - &y))] {
            match ball.strict_sign() {
                Some(1) => prop_assert!(*value > RBig::ZERO),
                Some(_) => prop_assert!(*value < RBig::ZERO),
                None => {
                    let [middle, error] = exact(ball);
                    prop_assert!(size(middle) * power(-10) <= error * (RBig::ONE + power(-10)));
                }
            }
        }
    }

    /// Errors stay small: some units of the last place.
    #[test]
    fn what_is_sharp_stays_sharp(x in rationals(), y in rationals()) {
        prop_assume!(!x.is_zero() && !y.is_zero());
        let [a, b] = [&x, &y].map(Small::of);
        for found in [&a * &b, a.over(&b).unwrap(), a.square().root().unwrap()] {
            prop_assert!(found.error < 32.0 * Small::LAST, "{found:?}");
        }
    }
}

#[test]
fn what_has_no_value_has_no_ball() {
    let one = Small::whole(1);
    let zero = &one - &one;
    assert!(one.over(&zero).is_none() && (-&one).root().is_none() && zero.strict_sign().is_none());
    assert!(zero.root().unwrap().strict_sign().is_none());
    assert_eq!((&one + &Small::whole(-3)).to_f64().to_bits(), (-2.0_f64).to_bits());
}

/// An error that doubles do not hold is infinite, and then nothing is claimed.
#[test]
fn errors_beyond_doubles_claim_nothing() {
    let lost = Small::whole(1).widened(f64::INFINITY);
    for found in [&lost * &Small::whole(3), &lost - &lost, &(&lost * &lost) + &Small::whole(1)] {
        assert!(found.strict_sign().is_none() && found.recip().is_none() && !found.error.is_finite(), "{found:?}");
    }
}
