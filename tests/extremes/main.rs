//! On the way into each extreme of docs/accuracy.md `fast` is right or says that it does not know.

mod families;

use families::{Answer, EXTREMES, answers};

#[test]
fn fast_is_never_wrong_in_the_extremes_and_right_where_they_begin() {
    for extreme in &EXTREMES {
        let mut decided = 0;
        for exponent in extreme.exponents.clone() {
            let [fast, exact] = answers(&extreme.ask(exponent));
            assert_ne!(fast, Answer::Wrong, "{} at ε = 1e-{exponent}", extreme.name);
            if fast == Answer::Right {
                decided += 1;
                assert_eq!(exact, Answer::Right);
            }
        }
        assert!(decided >= 3, "{}: fast answered {decided} only", extreme.name);
    }
}
