// Quarter of a plate 40 x 40 x 4 mm with a hole of radius 10 mm, hexahedra only.
// gmsh -3 -format msh41 plate_with_hole.geo
r = 10; a = 40; t = 4; c = r*Cos(Pi/4);
Point(1) = {0,0,0}; Point(2) = {r,0,0}; Point(3) = {c,c,0}; Point(4) = {0,r,0};
Point(5) = {a,0,0}; Point(6) = {a,a,0}; Point(7) = {0,a,0};
Circle(1) = {2,1,3}; Circle(2) = {3,1,4};
Line(3) = {2,5}; Line(4) = {5,6}; Line(5) = {3,6}; Line(6) = {6,7}; Line(7) = {4,7};
Curve Loop(1) = {3,4,-5,-1}; Plane Surface(1) = {1};
Curve Loop(2) = {5,6,-7,-2}; Plane Surface(2) = {2};
Transfinite Curve{1,2,4,6} = 9;
Transfinite Curve{3,5,7} = 11 Using Progression 1.15;
Transfinite Surface{1} = {2,5,6,3}; Transfinite Surface{2} = {3,6,7,4};
Recombine Surface{1,2};
e1[] = Extrude {0,0,t} { Surface{1}; Layers{3}; Recombine; };
e2[] = Extrude {0,0,t} { Surface{2}; Layers{3}; Recombine; };
Physical Volume("plate") = {e1[1], e2[1]};
Physical Surface("symmetry y") = {e1[2]};
Physical Surface("pulled") = {e1[3]};
Physical Surface("symmetry x") = {e2[4]};
Physical Surface("hole") = {e1[5], e2[5]};
Physical Surface("bottom") = {1, 2};
