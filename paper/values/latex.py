"""Numbers and tables in LaTeX."""
from recorded import rounded


def many(number):
    """With thin spaces between thousands."""
    return f"{number:,}".replace(",", "\\,")


def power(number, digits=1):
    """As a multiple of a power of ten."""
    mantissa, exponent = f"{number:.{digits}e}".split("e")
    return f"\\ensuremath{{{mantissa}\\cdot10^{{{int(exponent)}}}}}"


def ten(word):
    """1e-7 as a power of ten."""
    exponent = int(word.removeprefix("1e"))
    return f"$10^{{{exponent}}}$" if exponent else "$1$"


def time(microseconds):
    value, unit = rounded(microseconds).split()
    return f"{value}\\,{unit}".replace("µ", "\\textmu ")


def percent(part, whole, digits=1):
    return f"{100 * part / whole:.{digits}f}"


def table(columns, head, body):
    lines = [f"\\begin{{tabular}}{{@{{}}{columns}@{{}}}}", "\\toprule", " & ".join(head) + " \\\\ \\midrule"]
    lines += [" & ".join(row) + " \\\\" for row in body]
    return "\n".join([*lines, "\\bottomrule", "\\end{tabular}", ""])
