# The diagram: the outlines of the regions and the curves, as SVG.
using JSON
atlas = JSON.parsefile("paper/atlas.json")
drawing = atlas["drawing"]
points(line) = join(("$(h),$(-l)" for (h, l) in line), " ")
open("julia.svg", "w") do file
    println(file, """<svg xmlns="http://www.w3.org/2000/svg" viewBox="-3 -9 28 9">""")
    for (number, region) in enumerate(atlas["regions"]), outline in drawing["regions"][region["id"]]["polygon"]
        println(file, """<polygon fill="hsl($(40number),70%,50%)" fill-opacity="0.3" points="$(points(outline))"/>""")
    end
    for curve in atlas["curves"]
        line = points(drawing["curves"][curve["id"]]["polyline"])
        println(file, """<polyline fill="none" stroke="black" stroke-width="0.03" points="$line"/>""")
    end
    println(file, "</svg>")
end
println(length(atlas["regions"]), " regions, ", length(atlas["curves"]), " curves")

# The section: the package NPZ reads the archive; the CSV has a line of names and then numbers.
using NPZ, DelimitedFiles
section = npzread("section.npz", ["theta", "psi", "sheet"])   # not all: meta is a text, which NPZ does not read
table, names = readdlm("section.csv", ',', header=true)
theta = section["theta"]
column = Float64.(table[:, findfirst(isequal("theta"), vec(names))])
println(length(theta), " points, theta from ", round(minimum(theta), digits=6), " to ", round(maximum(theta), digits=6))
println("NPZ and CSV are equal: ", theta == column)

# An orbit: from a saddle-centre, pushed by 1e-8, the distance grows at the rate that the eigenvalues say.
using LinearAlgebra
answer = JSON.parsefile("critical.json")
A, r = (parse.(Float64, answer[name]) for name in ("A", "r"))
start = first(c for c in answer["critical"] if c["stability"] == "saddle-centre")
gamma = Float64.(start["gamma"])
motion((g, l)) = [g × (l ./ A), l × (l ./ A) + r × g]
function step(x, dt)   # the classical method of Runge and Kutta
    a = motion(x); b = motion(x + dt / 2 * a); c = motion(x + dt / 2 * b); d = motion(x + dt * c)
    x + dt / 6 * (a + 2b + 2c + d)
end
follow(x, time) = foldl((y, _) -> step(y, 1e-3), 1:round(Int, time / 1e-3), init=x)
at20 = follow([gamma, start["omega"] * A .* gamma + [1e-8, 0, 0]], 20)
at30 = follow(at20, 10)
growth = log(norm(at30[1] - gamma) / norm(at20[1] - gamma)) / 10
println("growth ", round(growth, digits=3), ", eigenvalue ", round(maximum(first.(start["eigenvalues"])), digits=3))
