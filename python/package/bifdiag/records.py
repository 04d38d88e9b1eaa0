"""What the documents of the program hold, as records: read-only, comparable, picklable, with all their fields printed.

Written by ``cargo run --release --example records`` from the JSON Schemas of the documents.
"""

from dataclasses import dataclass
from typing import Any

from . import behaviour
from .behaviour import Document, infinite, maybe, span


@dataclass(frozen=True, slots=True)
class Component:
    """One connected component of U_hl with the components of E_hl and P_hl above it.

    Attributes
    ----------
    boundary_circles : int
        k: the component of U_hl is the sphere without k discs.
    poles : tuple[str, ...] or None
        The poles inside: ``+`` for r̂ and ``-`` for −r̂; None when r = 0.
    accessible_region : str
        Its name: ``S2`` (the sphere), ``D2`` (a disc), ``S2-2D2`` (an annulus), … ``S2-kD2``.
    energy_surface : str
        The component of E_hl above it: ``RP3``, ``S3``, ``S1xS2``, ``(S1xS2)#(S1xS2)``, ``#3(S1xS2)`` … ``#(k-1)(S1xS2)``.
    section : str or None
        The component of P_hl above it, by genus: ``S2``, ``T2``, ``M2``, ``M3``, …; None when r = 0.
    genus : int or None
        Genus of ``section``: k + n − 1 with n poles inside; None when r = 0.
    """

    boundary_circles: int
    poles: tuple[str, ...] | None
    accessible_region: str
    energy_surface: str
    section: str | None
    genus: int | None

    @classmethod
    def _of(cls, document: Document) -> "Component":
        return cls(
            document["boundary_circles"],
            maybe(tuple, document["poles"]),
            document["accessible_region"],
            document["energy_surface"],
            document["section"],
            document["genus"],
        )


@dataclass(frozen=True, slots=True)
class Margin:
    """Distance in h to the nearest curve. With ``fast``, curves that begin or end within rounding (1e-14) of l count on
    both sides; with ``exact``, those at l itself.

    Attributes
    ----------
    h : float
        ``|h − h_c|`` to the nearest critical curve or pole line at this l.
    nearest : str
        Id of that curve; ``l=0`` at rest without weight, where no curve of the atlas is nearest.
    error_bound : float
        Bound on the error of ``h``.
    """

    h: float
    nearest: str
    error_bound: float

    @classmethod
    def _of(cls, document: Document) -> "Margin":
        return cls(
            document["h"],
            document["nearest"],
            document["error_bound"],
        )


@dataclass(frozen=True, slots=True)
class Candidate:
    """A region that meets at a critical or undecided point; without an atlas, a class.

    Attributes
    ----------
    region : str or None
        Id of the region; None for the forbidden region, and without an atlas.
    status : str
        ``regular``, or ``forbidden`` for the region below the lowest critical value.
    components : tuple[Component, ...]
        The components of U_hl there; none in the forbidden region.
    """

    region: str | None
    status: str
    components: tuple[Component, ...]

    @classmethod
    def _of(cls, document: Document) -> "Candidate":
        return cls(
            document["region"],
            document["status"],
            tuple(map(Component._of, document["components"])),
        )


@dataclass(frozen=True, slots=True, repr=False)
class Classification(behaviour.Classification):
    """The answer of ``classify``.

    Attributes
    ----------
    h : str
        Energy as given.
    l : str
        Vertical angular momentum as given.
    status : str
        What is known of the point. ``"regular"``: Inside a region; ``components`` holds the answer. ``"forbidden"``: Below
        the lowest critical value: U_hl is empty. ``"critical"``: Exactly on a curve (proved); ``candidates`` holds every
        region that meets there, with ``fast`` those beside curves within the error bound too. ``"undecided"``: Closer to a
        curve than the error bound (only with ``fast``); ``candidates`` holds every possible region.
    accuracy : str
        The requested level of accuracy. ``"exact"``: Never undecided: ``f64`` where its error bounds suffice, exact
        arithmetic elsewhere. ``"fast"``: ``f64`` with error bounds; undecided where they do not suffice.
    region : str or None
        Id of the region in the body's atlas; None unless regular, with ``--no-region``, and where no atlas gives it
        (``note`` says so).
    margin : Margin
        Distance to the nearest curve.
    components : tuple[Component, ...] or None
        The components of U_hl (none when forbidden); None when critical or undecided.
    signature : str or None
        The sections' names joined by ``+``; None when r = 0, when forbidden, and when no single class is known.
    candidates : tuple[Candidate, ...]
        Each region that meets at a critical or undecided point, once; without an atlas, each class.
    note : str or None
        What of a point is not known or not defined, and why.
    """

    h: str
    l: str
    status: str
    accuracy: str
    region: str | None
    margin: Margin
    components: tuple[Component, ...] | None
    signature: str | None
    candidates: tuple[Candidate, ...]
    note: str | None

    @classmethod
    def _of(cls, document: Document) -> "Classification":
        return cls(
            document["h"],
            document["l"],
            document["status"],
            document["accuracy"],
            document["region"],
            Margin._of(document["margin"]),
            maybe(lambda found: tuple(map(Component._of, found)), document["components"]),
            document["signature"],
            tuple(map(Candidate._of, document.get("candidates", ()))),
            document.get("note"),
        )


@dataclass(frozen=True, slots=True)
class Sample(behaviour.Sample):
    """A point inside a region, chosen where it is wide relative to the energies there; where no double lies inside, the
    doubles nearest to a point inside, which the certificate has exactly.

    Attributes
    ----------
    h : float
        Energy.
    l : float
        Vertical angular momentum.
    margin : Margin
        Distance of the exact point to the boundary. With a certificate its ``error_bound`` holds for the rounded point too,
        unless a curve begins or ends in between.
    """

    h: float
    l: float
    margin: Margin

    @classmethod
    def _of(cls, document: Document) -> "Sample":
        return cls(
            document["h"],
            document["l"],
            Margin._of(document["margin"]),
        )


@dataclass(frozen=True, slots=True)
class Neighbour:
    """A region on the other side of a curve.

    Attributes
    ----------
    region : str or None
        Id of the region; None: the forbidden region below the lowest critical value.
    curve : str
        Id of the curve crossed.
    """

    region: str | None
    curve: str

    @classmethod
    def _of(cls, document: Document) -> "Neighbour":
        return cls(
            document["region"],
            document["curve"],
        )


@dataclass(frozen=True, slots=True)
class Cell:
    """A part of a region: all (h, l) between two curves over a range of l that no event divides.

    Attributes
    ----------
    l_range : tuple[float, float]
        Range of l; an infinite end is ``inf`` (the lower one ``-inf``).
    lower : str
        Id of the curve below (to the left in h).
    upper : str or None
        Id of the curve above; None: unbounded.
    """

    l_range: tuple[float, float]
    lower: str
    upper: str | None

    @classmethod
    def _of(cls, document: Document) -> "Cell":
        return cls(
            span(document["l_range"]),
            document["lower"],
            document["upper"],
        )


@dataclass(frozen=True, slots=True, repr=False)
class Region(behaviour.Region):
    """A connected face of the (h, l) half-plane l > 0, on which the topology is constant.

    Attributes
    ----------
    id : str
        Id, unique in the atlas.
    sample : Sample
        A well-placed point inside.
    components : tuple[Component, ...]
        The components of U_hl; none where they are not decided (``fast``).
    signature : str or None
        The sections' names joined by ``+``; None when r = 0, and where they are not decided (``fast``).
    bounded : bool
        True when the region is bounded in the (h, l) plane.
    l_range : tuple[float, float]
        Range of l; an infinite end is ``inf`` (the lower one ``-inf``).
    boundary : tuple[str, ...]
        Ids of the curves on the boundary, each once: below and above each cell, in the order of ``cells``.
    neighbours : tuple[Neighbour, ...]
        The regions across curves of the boundary, one for each region and curve; across a pole line that coincides with
        another curve none. With a window only listed regions, and the forbidden one.
    cells : tuple[Cell, ...]
        The cells whose union it is, by rising l, then h.
    clipped : bool
        True when a window cuts it. The ``sample`` of a cut region lies in the window; ``cells``, ``l_range`` and
        ``h_width`` are those of the whole.
    """

    id: str
    sample: Sample
    components: tuple[Component, ...]
    signature: str | None
    bounded: bool
    l_range: tuple[float, float]
    boundary: tuple[str, ...]
    neighbours: tuple[Neighbour, ...]
    cells: tuple[Cell, ...]
    clipped: bool

    @classmethod
    def _of(cls, document: Document, drawn: Any) -> "Region":
        made = cls(
            document["id"],
            Sample._of(document["sample"]),
            tuple(map(Component._of, document["components"])),
            document["signature"],
            document["bounded"],
            span(document["l_range"]),
            tuple(document["boundary"]),
            tuple(map(Neighbour._of, document["neighbours"])),
            tuple(map(Cell._of, document["cells"])),
            document.get("clipped", False),
        )
        return made._with(drawn)


@dataclass(frozen=True, slots=True)
class Enclosure:
    """Proved bounds of a point, as decimals. In l² they are at most as wide as the enclosure of the certificate and four
    roundings (2⁻⁵²) of l², in h as that and four roundings of ``|h| + |r|``.

    Attributes
    ----------
    l : tuple[str, str]
        l lies between these; the lower one is not negative.
    h : tuple[str, str]
        h lies between these.
    """

    l: tuple[str, str]
    h: tuple[str, str]

    @classmethod
    def _of(cls, document: Document) -> "Enclosure":
        return cls(
            tuple(document["l"]),
            tuple(document["h"]),
        )


@dataclass(frozen=True, slots=True)
class Event:
    """A point where curves meet.

    Attributes
    ----------
    kind : str
        What happens. ``"cusp"``: Two curves meet and vanish. ``"pitchfork"``: A symmetric pair or a circle leaves a curve;
        ``curves`` holds the curve before, the curve after, and the pair or circle. ``"crossing"``: Two curves cross.
    l : float
        Vertical angular momentum.
    h : float
        Energy.
    curves : tuple[str, ...]
        Ids of the curves that meet.
    l_error : float
        Bound on the error of ``l``; with a certificate at most the width of the enclosure and two roundings of l.
    h_error : float
        Bound on the error of ``h``; with a certificate at most the width of the enclosure and four roundings of ``|h| +
        |r|``.
    enclosure : Enclosure or None
        Proved bounds (certified only).
    """

    kind: str
    l: float
    h: float
    curves: tuple[str, ...]
    l_error: float
    h_error: float
    enclosure: Enclosure | None

    @classmethod
    def _of(cls, document: Document) -> "Event":
        return cls(
            document["kind"],
            document["l"],
            document["h"],
            tuple(document["curves"]),
            document["l_error"],
            document["h_error"],
            maybe(Enclosure._of, document.get("enclosure")),
        )


@dataclass(frozen=True, slots=True)
class StabilityChange:
    """A point of a branch at which the linear type changes: a root of the polynomials of Proposition 13.4 of
    docs/algorithms.md, isolated exactly.

    Attributes
    ----------
    l : float
        Vertical angular momentum.
    h : float
        Energy.
    curve : str
        Id of the curve on which it lies; at a cusp or pitchfork the first of the two.
    onto : str or None
        Id of the curve that continues after a cusp or pitchfork.
    kind : str
        What happens. ``"hamiltonian-hopf"``: Two imaginary pairs of opposite Krein sign meet and leave the imaginary axis.
        ``"real-collision"``: Two real pairs meet and become a complex quadruple. ``"zero"``: A pair of eigenvalues goes
        through zero, or two pairs where moments are equal, at a cusp or pitchfork.
    from_ : str
        The type at smaller l or, at a cusp or pitchfork, on ``curve``. ``"elliptic"``: Two imaginary pairs; across a circle
        of equilibria one pair. ``"saddle-centre"``: One real and one imaginary pair. ``"saddle"``: Two real pairs; across a
        circle of equilibria one pair. ``"complex"``: A complex quadruple. ``"double-elliptic"``: A double imaginary pair.
        ``"double-real"``: A double real pair. ``"zero"``: An eigenvalue zero.
    to : str
        The type at larger l or, at a cusp or pitchfork, on ``onto``.
    error_bound : float
        Bound on the errors of ``l`` and ``h``; with a certificate at most 256 roundings (2⁻⁵²) of ``l + |h| + |r|``.
    """

    l: float
    h: float
    curve: str
    onto: str | None
    kind: str
    from_: str
    to: str
    error_bound: float

    @classmethod
    def _of(cls, document: Document) -> "StabilityChange":
        return cls(
            document["l"],
            document["h"],
            document["curve"],
            document.get("onto"),
            document["kind"],
            document["from"],
            document["to"],
            document["error_bound"],
        )


@dataclass(frozen=True, slots=True)
class VerdictChange:
    """A point of a curve at which a hypothesis of Arnold's theorem fails, whether or not the verdict changes there.

    Attributes
    ----------
    l : float
        Vertical angular momentum.
    h : float
        Energy.
    curve : str
        Id of the curve on which it lies.
    kind : str
        What fails. ``"1:1"``: ω₁ = ω₂. ``"1:2"``: ω₁ = 2ω₂. ``"1:3"``: ω₁ = 3ω₂. ``"D4"``: D₄ = 0.
    verdict : str
        The verdict at the point itself. ``"stable"``: Motions that start near it stay near it for all time. ``"unstable"``:
        Some motions that start arbitrarily near leave it. ``"open"``: None of the theorems that the program uses decides.
    why : str
        Why. ``"energy"``: A strict minimum of U_l (Lagrange–Dirichlet), or a circle or sphere of minima as a whole.
        ``"integral"``: A further integral, as at the sleeping top. ``"arnold"``: Arnold's theorem: no resonance ω₁ = ω₂,
        2ω₂ or 3ω₂, and D₄ is not 0; or D₄ = 0, no resonance k₁ω₁ = k₂ω₂ with k₁ + k₂ ≤ 6, and D₆ is not 0. Also at ω₁ = 2ω₂
        where the resonant cubic term vanishes. ``"spectrum"``: An eigenvalue with positive real part. ``"resonance 1:2"``:
        ω₁ = 2ω₂. ``"resonance 1:3"``: ω₁ = 3ω₂. ``"resonance 1:1"``: ω₁ = ω₂. ``"degenerate"``: An eigenvalue zero, or D₄ =
        0 where D₆ does not decide.
    changes : bool
        The verdicts before and after differ.
    error_bound : float
        Bound on the errors of ``l`` and ``h``.
    proved : bool
        ``verify`` confirms it.
    """

    l: float
    h: float
    curve: str
    kind: str
    verdict: str
    why: str
    changes: bool
    error_bound: float
    proved: bool

    @classmethod
    def _of(cls, document: Document) -> "VerdictChange":
        return cls(
            document["l"],
            document["h"],
            document["curve"],
            document["kind"],
            document["verdict"],
            document["why"],
            document["changes"],
            document["error_bound"],
            document["proved"],
        )


@dataclass(frozen=True, slots=True)
class Resonances:
    """Distances to the resonances, from the coefficients of λ⁴ + bλ² + c; each vanishes at its resonance, to rounding.

    Attributes
    ----------
    one_to_one : float
        (b² − 4c)/b².
    one_to_two : float
        (4b² − 25c)/b².
    one_to_three : float
        (9b² − 100c)/b².
    """

    one_to_one: float
    one_to_two: float
    one_to_three: float

    @classmethod
    def _of(cls, document: Document) -> "Resonances":
        return cls(
            document["1:1"],
            document["1:2"],
            document["1:3"],
        )


@dataclass(frozen=True, slots=True)
class Nonlinear:
    """The verdict on the stability of a relative equilibrium, with its evidence.

    Attributes
    ----------
    verdict : str
        Stable, unstable, or open. ``"stable"``: Motions that start near it stay near it for all time. ``"unstable"``: Some
        motions that start arbitrarily near leave it. ``"open"``: None of the theorems that the program uses decides.
    why : str
        Why. ``"energy"``: A strict minimum of U_l (Lagrange–Dirichlet), or a circle or sphere of minima as a whole.
        ``"integral"``: A further integral, as at the sleeping top. ``"arnold"``: Arnold's theorem: no resonance ω₁ = ω₂,
        2ω₂ or 3ω₂, and D₄ is not 0; or D₄ = 0, no resonance k₁ω₁ = k₂ω₂ with k₁ + k₂ ≤ 6, and D₆ is not 0. Also at ω₁ = 2ω₂
        where the resonant cubic term vanishes. ``"spectrum"``: An eigenvalue with positive real part. ``"resonance 1:2"``:
        ω₁ = 2ω₂. ``"resonance 1:3"``: ω₁ = 3ω₂. ``"resonance 1:1"``: ω₁ = ω₂. ``"degenerate"``: An eigenvalue zero, or D₄ =
        0 where D₆ does not decide.
    D4_over_s : float or None
        Arnold's determinant D₄ = K₁₁ω₂² + K₁₂ω₁ω₂ + K₂₂ω₁² over Ω², where H = ω₁I₁ − ω₂I₂ + K₁₁I₁² + K₁₂I₁I₂ + K₂₂I₂² + …
        with the pair of positive Krein sign first; None except at index 2 with two distinct imaginary pairs, and there too
        where a further integral decides, at a resonance 1:2 that makes it unstable, and along a curve.
    D4_error : float or None
        Bound on its error.
    near : Resonances or None
        Distances to the resonances; None except at index 2 with imaginary pairs, and there too where a further integral
        decides, and along a curve.
    proved : bool
        Decided by enclosures and exact arithmetic; in an atlas: ``verify`` confirms it.
    """

    verdict: str
    why: str
    D4_over_s: float | None
    D4_error: float | None
    near: Resonances | None
    proved: bool

    @classmethod
    def _of(cls, document: Document) -> "Nonlinear":
        return cls(
            document["verdict"],
            document["why"],
            document["D4_over_s"],
            document["D4_error"],
            maybe(Resonances._of, document["near"]),
            document["proved"],
        )


@dataclass(frozen=True, slots=True)
class Friction:
    """A relative equilibrium with friction that conserves l (Thomson, Tait and Chetaev): it survives exactly at a minimum
    of U_l.

    Attributes
    ----------
    conserving_l : str or None
        What it leaves; None at a degenerate point that no theorem decides.
    growing : int
        Directions that grow: the Morse index.
    rates : tuple[tuple[tuple[float, float], float], ...]
        Pairs of ``eigenvalues``, each with d Re λ/dδ at δ = 0 for the torque −δA(ω − Ωγ): of an imaginary pair negative
        exactly if its Krein sign is positive. Without double pairs and zeros; empty along a curve. Computed in doubles:
        they grow without bound towards a collision of eigenvalues, and lose digits there.
    """

    conserving_l: str | None
    growing: int
    rates: tuple[tuple[tuple[float, float], float], ...]

    @classmethod
    def _of(cls, document: Document) -> "Friction":
        return cls(
            document["conserving_l"],
            document["growing"],
            tuple((tuple(pair[0]), pair[1]) for pair in document["rates"]),
        )


@dataclass(frozen=True, slots=True)
class StabilitySpan:
    """A stretch of a curve with one kind of stability.

    Attributes
    ----------
    l_from : float
        Where it begins.
    l_to : float
        Where it ends; ``inf`` at infinity.
    stability : str
        The linear type there. ``"elliptic"``: Two imaginary pairs; across a circle of equilibria one pair.
        ``"saddle-centre"``: One real and one imaginary pair. ``"saddle"``: Two real pairs; across a circle of equilibria
        one pair. ``"complex"``: A complex quadruple. ``"double-elliptic"``: A double imaginary pair. ``"double-real"``: A
        double real pair. ``"zero"``: An eigenvalue zero.
    nonlinear : Nonlinear
        The verdict there, except at isolated points, which ``verdict_changes`` lists.
    friction : Friction
        What friction leaves of it.
    """

    l_from: float
    l_to: float
    stability: str
    nonlinear: Nonlinear
    friction: Friction

    @classmethod
    def _of(cls, document: Document) -> "StabilitySpan":
        return cls(
            document["l_from"],
            infinite(document["l_to"]),
            document["stability"],
            Nonlinear._of(document["nonlinear"]),
            Friction._of(document["friction"]),
        )


@dataclass(frozen=True, slots=True)
class Tail:
    """The asymptote of a curve: h = l²/(2 J) + h0 + O(l⁻²).

    Attributes
    ----------
    moment : float
        J: the moment of inertia of the limiting axis.
    h_offset : float
        h0.
    """

    moment: float
    h_offset: float

    @classmethod
    def _of(cls, document: Document) -> "Tail":
        return cls(
            document["moment"],
            document["h_offset"],
        )


@dataclass(frozen=True, slots=True, repr=False)
class Curve(behaviour.Curve):
    """A curve of critical values, or a pole line: a piece of a branch along which l is monotone.

    Attributes
    ----------
    id : str
        Id, unique in the atlas.
    kind : str
        What it consists of. ``"generic"``: Relative equilibria of the generic family γ(μ). ``"pair"``: A symmetric pair
        over μ = A_i with r_i = 0. ``"circle"``: A circle of relative equilibria (bodies with two equal moments).
        ``"axis"``: Rotation about a principal axis: a straight line in (l², h). ``"pole-plus"``: r̂ enters U_hl.
        ``"pole-minus"``: −r̂ enters U_hl. ``"sphere"``: All of S² is critical.
    branch : str
        Branch: curves that continue each other through cusps and pitchforks share it.
    branch_name : str
        The branch in words: ``from +r̂``, ``between axis 1 and axis 2``, ``pair over axis 2``, ``circle over axes 1 and
        2``, …
    index : int or None
        Morse index; None for a pole line.
    multiplicity : int
        2 for a symmetric pair (a double curve), else 1.
    coincides_with : tuple[str, ...]
        Ids of the curves with the same (h, l): pole lines that run on critical curves.
    mu_range : tuple[float, float] or None
        Range of μ of the closed form; an infinite end is ``inf`` (the lower one ``-inf``). None for pole lines, and where r
        = 0.
    l_range : tuple[float, float]
        Range of l; an infinite end is ``inf`` (the lower one ``-inf``).
    stability : tuple[StabilitySpan, ...]
        The linear type along the curve, by rising l; empty for pole lines, and with a window for curves that have no l in
        common with it.
    tail : Tail or None
        Asymptotics for l → ∞; None for a curve with two finite ends.
    """

    id: str
    kind: str
    branch: str
    branch_name: str
    index: int | None
    multiplicity: int
    coincides_with: tuple[str, ...]
    mu_range: tuple[float, float] | None
    l_range: tuple[float, float]
    stability: tuple[StabilitySpan, ...]
    tail: Tail | None

    @classmethod
    def _of(cls, document: Document, drawn: Any) -> "Curve":
        made = cls(
            document["id"],
            document["kind"],
            document["branch"],
            document["branch_name"],
            document["index"],
            document["multiplicity"],
            tuple(document["coincides_with"]),
            maybe(span, document.get("mu_range")),
            span(document["l_range"]),
            tuple(map(StabilitySpan._of, document["stability"])),
            maybe(Tail._of, document["tail"]),
        )
        return made._with(drawn)


@dataclass(frozen=True, slots=True)
class ChaosShare:
    """The chaotic share of a component of E, in Liouville measure.

    Attributes
    ----------
    accessible_region : str
        The component of U over which it lies, such as ``D2``.
    energy_surface : str
        The component of E, such as ``S3``.
    fraction : float
        The share of the orbits known to be chaotic; apart from the sampling error, the true share lies between this and
        ``fraction`` + ``open``.
    error : float
        One standard deviation of ``fraction``.
    open : float
        The share of the orbits without a verdict.
    orbits : int
        How many orbits were judged.
    crossings : int
        How often they crossed the section S = 0, as seen at the steps of the integrator.
    """

    accessible_region: str
    energy_surface: str
    fraction: float
    error: float
    open: float
    orbits: int
    crossings: int

    @classmethod
    def _of(cls, document: Document) -> "ChaosShare":
        return cls(
            document["accessible_region"],
            document["energy_surface"],
            document["fraction"],
            document["error"],
            document["open"],
            document["orbits"],
            document["crossings"],
        )


@dataclass(frozen=True, slots=True)
class ChaosPoint:
    """The answer of ``chaos`` at one point.

    Attributes
    ----------
    h : str
        Energy as given.
    l : str
        Vertical angular momentum as given.
    region : str or None
        The region of the point; None where no atlas was made.
    steps : int
        Steps of the integrator after which an orbit is left open.
    components : tuple[ChaosShare, ...]
        One entry for each component of E, in the order of ``classify``.
    """

    h: str
    l: str
    region: str | None
    steps: int
    components: tuple[ChaosShare, ...]

    @classmethod
    def _of(cls, document: Document) -> "ChaosPoint":
        return cls(
            document["h"],
            document["l"],
            document.get("region"),
            document["steps"],
            tuple(map(ChaosShare._of, document["components"])),
        )
