% The diagram as SVG: the outlines of the regions and the curves. Without 'makeValidName', P+ and P- would be one field.
atlas = jsondecode(fileread('paper/atlas.json'), 'makeValidName', false);
file = fopen('octave.svg', 'w');
fprintf(file, '<svg xmlns="http://www.w3.org/2000/svg" viewBox="-3 -9 28 9"><g fill-opacity="0.3">\n');
for k = 1:numel(atlas.regions)
  outlines = atlas.drawing.regions.(atlas.regions(k).id).polygon;
  if ~iscell(outlines), outlines = {squeeze(outlines)}; end   % a single outline comes as an array
  for m = 1:numel(outlines)
    points = sprintf('%.4f,%.4f ', (outlines{m} .* [1, -1])');
    fprintf(file, '<polygon fill="hsl(%d,70%%,50%%)" points="%s"/>\n', 40 * k, points);
  end
end
curves = fieldnames(atlas.drawing.curves);
for k = 1:numel(curves)
  points = sprintf('%.4f,%.4f ', (atlas.drawing.curves.(curves{k}).polyline .* [1, -1])');
  fprintf(file, '<polyline fill="none" stroke="black" stroke-width="0.03" points="%s"/>\n', points);
end
fprintf(file, '</g></svg>\n');
fclose(file);
fprintf('%d regions, %d curves\n', numel(atlas.regions), numel(curves));

% The section: an NPZ file is a ZIP archive of arrays, each with a header of text whose length stands in bytes 9 and 10.
unzip('section.npz', 'arrays');
file = fopen('arrays/theta.npy', 'r', 'ieee-le');
fseek(file, 8, 'bof');
fseek(file, fread(file, 1, 'uint16'), 'cof');
theta = fread(file, Inf, 'double');
fclose(file);
table = dlmread('section.csv', ',', 1, 0);
fprintf('%d points, theta from %.6f to %.6f\n', numel(theta), min(theta), max(theta));
fprintf('NPZ and CSV are equal: %d\n', isequal(theta, table(:, 12)));

% An orbit: from a saddle-centre, pushed by 1e-8, the distance grows at the rate that the eigenvalues say.
answer = jsondecode(fileread('critical.json'));
A = cellfun(@str2double, answer.A);
r = cellfun(@str2double, answer.r);
start = answer.critical(find(strcmp({answer.critical.stability}, 'saddle-centre'), 1));
gamma = start.gamma;
motion = @(t, x) [cross(x(1:3), x(4:6) ./ A); cross(x(4:6), x(4:6) ./ A) + cross(r, x(1:3))];
state = [gamma; start.omega * A .* gamma] + [0; 0; 0; 1e-8; 0; 0];
[t, x] = ode45(motion, [0, 20, 30], state, odeset('RelTol', 1e-12, 'AbsTol', 1e-14));
distance = sqrt(sum((x(:, 1:3) - gamma') .^ 2, 2));
fprintf('growth %.3f, eigenvalue %.3f\n', log(distance(3) / distance(2)) / 10, max(start.eigenvalues(:, 1)));
