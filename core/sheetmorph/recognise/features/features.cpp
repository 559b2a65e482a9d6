// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/features.h"

#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/recognise/facets/facet_graph.h"
#include "sheetmorph/recognise/features/bends.h"
#include "sheetmorph/recognise/features/holes.h"
#include "sheetmorph/recognise/features/strips.h"
#include "sheetmorph/recognise/features/washers.h"
#include "sheetmorph/recognise/surfaces/surfaces.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace sheetmorph::recognise
{

namespace
{

bool is_hole(const Feature& feature)
{
    return feature.kind <= FeatureKind::hole;
}

// Converts vertices of the merged mesh to vertices of the given mesh.
void renumber(const FacetGraph& graph, Feature& feature)
{
    feature.vertices = graph.originals(feature.vertices);
    for (VertexIds& rim : feature.rims)
        rim = graph.representatives(rim);
    for (VertexIds& ring : feature.washer)
        ring = graph.originals(ring);
}

bool is_same_rim(VertexIds one, VertexIds other)
{
    make_set(one);
    make_set(other);
    return one == other;
}

// Whether the raised region was already found, either from its sharp edge or as a blind hole with
// the same rim.
bool is_known(const std::vector<Feature>& features, const Feature& raised)
{
    for (const Feature& feature : features)
    {
        if (is_hole(feature) && is_same_rim(feature.rims.front(), raised.rims.front()))
            return true;
        if (feature.kind != FeatureKind::bead && feature.kind != FeatureKind::emboss)
            continue;
        VertexIds both;
        std::set_intersection(feature.vertices.begin(), feature.vertices.end(),
                              raised.vertices.begin(), raised.vertices.end(),
                              std::back_inserter(both));
        if (2 * both.size() > std::min(feature.vertices.size(), raised.vertices.size()))
            return true;
    }
    return false;
}

void add_surfaces(const FacetGraph& graph, const FeatureTolerances& tolerances,
                  std::vector<Feature>& features)
{
    const std::vector<SurfaceRegion> surfaces = find_surfaces(graph, tolerances);
    for (const Feature& raised : find_embosses(graph, surfaces, tolerances))
        if (!is_known(features, raised))
            features.push_back(raised);
    for (const SurfaceRegion& region : surfaces)
        features.push_back(feature_of(graph, region));
    for (const Feature& flange : find_flanges(graph, surfaces, tolerances))
        features.push_back(flange);
    for (const Feature& bend : find_bends(graph, surfaces, tolerances))
        features.push_back(bend);
}

}  // namespace

std::vector<Feature> find_features(const mesh::TriangleMesh& mesh,
                                   const FeatureTolerances& tolerances)
{
    tolerances.check();
    const FacetGraph graph(mesh, tolerances.weld, tolerances.scatter);
    std::vector<Feature> features = find_rims(graph, tolerances);
    add_surfaces(graph, tolerances, features);
    const WasherGrower washers(graph);
    for (Feature& feature : features)
    {
        if (is_hole(feature))
            feature.washer = washers.rings(feature.vertices, tolerances.washer_rings);
        renumber(graph, feature);
        feature.scatter = graph.scatter();
    }
    std::stable_sort(features.begin(), features.end(),
                     [](const Feature& a, const Feature& b) {
                         return std::tuple(a.kind, a.vertices.front())
                                < std::tuple(b.kind, b.vertices.front());
                     });
    return features;
}

}  // namespace sheetmorph::recognise
