(* The diagram: the outlines of the regions and the curves. *)
atlas = Import["paper/atlas.json", "JSON"];
{regions, curves, drawing} = {"regions", "curves", "drawing"} /. atlas;
outlines[id_] := "polygon" /. (id /. ("regions" /. drawing));
line[id_] := "polyline" /. (id /. ("curves" /. drawing));
colored = Table[{Hue[k/10], Map[Polygon, outlines["id" /. regions[[k]]]]}, {k, Length[regions]}];
window = {"h", "l"} /. ("main" /. ("view" /. drawing));
black = Map[Line[line["id" /. #]] &, curves];
Export["wolfram.svg", Graphics[{colored, Black, black}, Axes -> True, PlotRange -> window, AspectRatio -> 1/2]];
Print[Length[regions], " regions, ", Length[curves], " curves"];

(* The section, from CSV: a line of names, then the points. *)
{names, points} = {First[#], Rest[#]} &[Import["section.csv", "CSV"]];
column[name_] := Module[{n = First[Flatten[Position[names, name]]]}, Map[number[#[[n]]] &, points]];
number[x_String] := N[ToExpression[StringReplace[x, "e" -> "*^"]]];  (* where Import leaves texts *)
number[x_] := x;
theta = column["theta"];
Print[Length[theta], " points, theta from ", Min[theta], " to ", Max[theta]];

(* An orbit: from a saddle-centre, pushed by 1e-8, the distance grows at the rate that the eigenvalues say. *)
answer = Import["critical.json", "JSON"];
{A, r} = Map[ToExpression, {"A", "r"} /. answer, {2}];
start = First[Select["critical" /. answer, ("stability" /. #) == "saddle-centre" &]];
gamma = "gamma" /. start;
motion[{g_, l_}] := {Cross[g, l/A], Cross[l, l/A] + Cross[r, g]};
step[x_, dt_] := Module[{a, b, c, d},  (* the classical method of Runge and Kutta *)
  a = motion[x]; b = motion[x + dt/2 a]; c = motion[x + dt/2 b]; d = motion[x + dt c];
  x + dt/6 (a + 2 b + 2 c + d)];
follow[x_, n_] := Nest[step[#, 0.05] &, x, n];
at20 = follow[{gamma, ("omega" /. start) A gamma + {10.^-8, 0, 0}}, 400];
at30 = follow[at20, 200];
growth = Log[Norm[at30[[1]] - gamma]/Norm[at20[[1]] - gamma]]/10;
Print["growth ", growth, ", eigenvalue ", Max[Map[First, "eigenvalues" /. start]]];
