// An L, 1 long and high, 0.2 thick, drawn out by 0.4 in y; with a round inner edge.
t = 0.2; r = 0.1;
Point(1) = {0, 0, 0};      Point(2) = {1, 0, 0};  Point(3) = {1, 0, t};
Point(4) = {t + r, 0, t};  Point(5) = {t, 0, t + r};  Point(6) = {t, 0, 1};
Point(7) = {0, 0, 1};      Point(8) = {t + r, 0, t + r};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Circle(4) = {4, 8, 5};
Line(5) = {5, 6};  Line(6) = {6, 7};  Line(7) = {7, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7};  Plane Surface(1) = {1};
part[] = Extrude {0, 0.4, 0} { Surface{1}; };

// Names for signorini. All other faces are boundary 0.
Physical Surface("sole") = {part[2]};
Physical Volume("bracket") = {part[1]};
Mesh.MeshSizeMin = 0.2;  Mesh.MeshSizeMax = 0.2;
