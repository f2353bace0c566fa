// The outline of the L in the plane y = 0: three rectangles that share edges.
t = 0.2;
Point(1) = {0, 0, 0};  Point(2) = {t, 0, 0};  Point(3) = {1, 0, 0};
Point(4) = {0, 0, t};  Point(5) = {t, 0, t};  Point(6) = {1, 0, t};
Point(7) = {0, 0, 1};  Point(8) = {t, 0, 1};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {4, 5};  Line(4) = {5, 6};
Line(5) = {7, 8};  Line(6) = {1, 4};  Line(7) = {2, 5};  Line(8) = {3, 6};
Line(9) = {4, 7};  Line(10) = {5, 8};
Curve Loop(1) = {1, 7, -3, -6};  Plane Surface(1) = {1};
Curve Loop(2) = {2, 8, -4, -7};  Plane Surface(2) = {2};
Curve Loop(3) = {3, 10, -5, -9}; Plane Surface(3) = {3};

// Two cells across the thickness, eight along the arms.
Transfinite Curve {1, 3, 5, 6, 7, 8} = 3;
Transfinite Curve {2, 4, 9, 10} = 9;
Transfinite Surface {1, 2, 3};
Recombine Surface {1, 2, 3};

// Drawn out by 0.4 in y, in four layers of hexahedra.
part[] = Extrude {0, 0.4, 0} { Surface{1, 2, 3}; Layers{4}; Recombine; };

// Names for signorini: the sole (z = 0) is boundary 1; all other faces are 0.
Physical Surface(1) = {part[2], part[8]};
Physical Volume(1) = {part[1], part[7], part[13]};
Mesh.MshFileVersion = 2.2;
