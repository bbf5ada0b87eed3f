// Quarter of a ring as a curved beam, radii 95 and 105 mm, 10 mm wide, hexahedra only, in no order: Gmsh's quadrilaterals
// of a free mesh, extruded.
// gmsh -3 -format msh41 curved_beam.geo
a = 95; b = 105; t = 10;
Point(1) = {0,0,0}; Point(2) = {a,0,0}; Point(3) = {b,0,0}; Point(4) = {0,b,0}; Point(5) = {0,a,0};
Line(1) = {2,3}; Circle(2) = {3,1,4}; Line(3) = {4,5}; Circle(4) = {5,1,2};
Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1};
Mesh.MeshSizeMin = 2.5; Mesh.MeshSizeMax = 2.5;
Mesh.Algorithm = 9; Mesh.RecombinationAlgorithm = 1;
Recombine Surface{1};
e[] = Extrude {0,0,t} { Surface{1}; Layers{4}; Recombine; };
Physical Volume("beam") = {e[1]};
Physical Surface("end") = {e[2]};
Physical Surface("outer") = {e[3]};
Physical Surface("foot") = {e[4]};
Physical Surface("inner") = {e[5]};
Physical Surface("bottom") = {1};
