/*!
\ingroup PkgShapeCorrespondenceConcepts
\cgalConcept

The concept `PartAbstractor` describes a function object that turns the mesh of one part into a curve or a sheet.
`CGAL::Shape_correspondence::Abstraction_options::abstractor` holds a model; the functions `abstract_part()`,
`abstract_parts()` and `build_structural_graph()` call it for every part. A part that is a copy of another one is not
passed: it gets the abstraction of the original, moved. Convex hull, area and surface samples are added by the caller.

Several threads may call one object at a time. What it returns must depend on its arguments only.

\cgalRefines `CopyConstructible`

\cgalHasModel `CGAL::Shape_correspondence::Fitted_abstraction`, the default
\cgalHasModel `CGAL::Shape_correspondence::Mean_curvature_abstraction`
\cgalHasModel `CGAL::Shape_correspondence::Bounding_box_abstraction`

\sa \ref Shape_correspondence/own_abstraction.cpp
*/
class PartAbstractor
{
public:
  /*!
  returns an abstraction whose `geometry` is a curve of two or more points, or a sheet of two or more rows and columns,
  all of them finite, in the coordinates of the mesh. `volume`, that of the enclosed solid, may be left 0, which means
  unknown. `report` reports how the abstraction was made; `report.fallback` is a reason to warn the user, or empty.

  \param part the part. Its mesh is in the frame of the shape (unit height, y up), or of the part alone when called by
    `abstract_part()`. Equal vertices are merged, no triangle occurs twice, and at least one has a positive area. The
  mesh may be open, non-manifold, of several components, and intersect itself.
  \param options the options of the call, among them the kind of abstraction wanted, `options.kind_of(part.name)`
  */
  CGAL::Shape_correspondence::Part_abstraction
  operator()(const CGAL::Shape_correspondence::Shape_part& part,
             const CGAL::Shape_correspondence::Abstraction_options& options) const;
};
