"""Makes Math.otf, the letters of formulas: those that pictures hold, from STIX Math, as large as DejaVu Sans beside them.

    apt-get download fonts-stix && dpkg-deb -x fonts-stix*.deb stix && pip install fonttools
    python3 subset.py stix/usr/share/fonts/opentype/stix-word/STIXMath-Regular.otf

Each letter stands at its plain code and is italic. The digits of exponents and indices, which other fonts draw each in its own
way, are digits of two thirds of the size, raised and lowered so far that they can stand one above the other.
"""

import sys
from pathlib import Path

from fontTools.fontBuilder import FontBuilder
from fontTools.misc.transform import Identity, Offset
from fontTools.pens.boundsPen import BoundsPen
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.pens.t2CharStringPen import T2CharStringPen
from fontTools.pens.transformPen import TransformPen
from fontTools.ttLib import TTFont
from fontTools.ttLib.tables._c_m_a_p import CmapSubtable

NAME = "Bifdiag Math"
# So large are capitals and small letters, in the mean, beside those of DejaVu Sans.
SCALE = 1.12
SCRIPT = 0.67
# Base lines of exponents and indices, in thousandths of the size.
RAISED, LOWERED = 385, -190
ITALIC = "ADEJMOPSTUehjklnrtxyz"
GREEK = "αγηθλμπφψω"
UPRIGHT = "Δ∂′"
EXPONENTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789−+"))
INDICES = dict(zip("₀₁₂₃₄₅₆₇₈₉", "0123456789")) | {"ⱼ": "j", "ₖ": "k"}

source = TTFont(sys.argv[1])
glyphs, cmap = source.getGlyphSet(), source.getBestCmap()


def italic(letter):
    """The glyph of a letter in mathematical italics."""
    if letter == "h":
        return cmap[0x210E]
    if letter == "ϑ":
        return cmap[0x1D717]
    first, start = next((a, b) for a, b in [("a", 0x1D44E), ("A", 0x1D434), ("α", 0x1D6FC)] if a <= letter <= chr(ord(a) + 25))
    return cmap[start + ord(letter) - ord(first)]


def bounds(glyph):
    pen = BoundsPen(glyphs)
    glyphs[glyph].draw(pen)
    return pen.bounds


def middle_top(glyph):
    left, _, right, top = bounds(glyph)
    return (left + right) / 2, top


def above(glyph, mark, gap):
    """Where a mark goes: its middle above that of a glyph, and to the right as italics lean."""
    (x, top), (left, bottom, right, _) = middle_top(glyph), bounds(mark)
    return Offset(x + 0.12 * top - (left + right) / 2, top + gap - bottom)


# For each character its parts, glyphs with where they go, and its advance.
parts = {}
for letter in ITALIC + GREEK + "ϑ":
    parts[letter] = [(italic(letter), Identity)], glyphs[italic(letter)].width
for letter in UPRIGHT:
    parts[letter] = [(cmap[ord(letter)], Identity)], glyphs[cmap[ord(letter)]].width
for table, base in (EXPONENTS, RAISED), (INDICES, LOWERED):
    for letter, plain in table.items():
        glyph = italic(plain) if plain.isalpha() else cmap[ord(plain)]
        to = Offset(0, base / SCALE).scale(SCRIPT)
        parts[letter] = [(glyph, to)], SCRIPT * glyphs[glyph].width
s, dot, r, hat = italic("S"), cmap[0x2D9], italic("r"), cmap[0x2C6]
parts["Ṡ"] = [(s, Identity), (dot, above(s, dot, 50))], glyphs[s].width
# The mark over r takes no room: it is drawn back over what stands before it.
parts["\u0302"] = [(hat, Offset(-glyphs[r].width, 0).transform(above(r, hat, 60)))], 0

names = {letter: f"u{ord(letter):04X}" for letter in parts}
strings, metrics = {}, {}
for name in ".notdef", "other":
    pen = T2CharStringPen(500, None)
    strings[name], metrics[name] = pen.getCharString(), (500, 0)
for letter in sorted(parts):
    drawn, advance = parts[letter]
    advance = round(SCALE * advance)
    pen = T2CharStringPen(advance, None)
    for glyph, to in drawn:
        recording = DecomposingRecordingPen(glyphs)
        glyphs[glyph].draw(recording)
        recording.replay(TransformPen(pen, Identity.scale(SCALE).transform(to)))
    strings[names[letter]] = pen.getCharString()
    metrics[names[letter]] = (advance, 0)

builder = FontBuilder(1000, isTTF=False)
builder.setupGlyphOrder([".notdef", "other", *(names[letter] for letter in sorted(parts))])
builder.setupCharacterMap({ord(letter): name for letter, name in names.items()})
# Programs that set a whole line in each of its fonts, and then take from each what is its own, would take another font for all of
# a line of which this one lacks a letter. So it lacks none; and no other letter is ever asked of it.
every = CmapSubtable.newSubtable(13)
every.platformID, every.platEncID, every.format, every.reserved, every.length, every.language = 3, 10, 13, 0, 0, 0
every.cmap = {code: names.get(chr(code), "other") for code in range(0x20, 0x10000) if not 0xD800 <= code < 0xE000}
builder.font["cmap"].tables.append(every)
# Some readers want the private part not to be empty.
builder.setupCFF(NAME.replace(" ", ""), {"FullName": NAME}, strings, {"StdVW": 76})
builder.setupHorizontalMetrics(metrics)
# The line of DejaVu Sans.
builder.setupHorizontalHeader(ascent=928, descent=-236)
copyright = source["name"].getDebugName(0).split(", consisting")[0]
plain = NAME.replace(" ", "")
naming = {"familyName": NAME, "styleName": "Italic", "psName": plain, "copyright": copyright, "licenseDescription": "SIL OFL 1.1"}
builder.setupNameTable(naming, mac=False)
builder.setupOS2(sTypoAscender=928, sTypoDescender=-236, usWinAscent=928, usWinDescent=236, fsSelection=1, fsType=0)
builder.setupPost(keepGlyphNames=False)
builder.font["head"].macStyle = 2
builder.font["head"].created = builder.font["head"].modified = source["head"].modified
builder.font.recalcTimestamp = False
builder.font.save(Path(__file__).with_name("Math.otf"))
