// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/edge_discretisation.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepMesh_Context.hxx>
#include <BRepMesh_Deflection.hxx>
#include <BRepMesh_EdgeDiscret.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepMesh_ShapeTool.hxx>
#include <BRepTools.hxx>
#include <IMeshData_Edge.hxx>
#include <IMeshData_Face.hxx>
#include <IMeshData_Model.hxx>
#include <IMeshTools_CurveTessellator.hxx>
#include <Message_ProgressIndicator.hxx>
#include <OSD_Parallel.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sheetmorph::cad
{

namespace
{

// How much longer the next piece of an edge may be, for each mm away from a shorter one. Chosen:
// each piece is at most about 1.5 times as long as the one before.
constexpr double growth = 0.4;

// An edge as points on it.
struct Pieces
{
    std::vector<gp_Pnt> points;
    std::vector<double> parameters;

    void add(const gp_Pnt& point, double parameter)
    {
        points.push_back(point);
        parameters.push_back(parameter);
    }
    double length(std::size_t piece) const { return points[piece].Distance(points[piece + 1]); }
};

// Hands pieces to BRepMesh.
class CutEdge : public IMeshTools_CurveTessellator
{
public:
    explicit CutEdge(const Pieces& pieces) : pieces_(pieces) {}

    Standard_Integer PointsNb() const override { return static_cast<int>(pieces_.points.size()); }

    Standard_Boolean Value(const Standard_Integer index, gp_Pnt& point,
                           Standard_Real& parameter) const override
    {
        point = pieces_.points[static_cast<std::size_t>(index - 1)];
        parameter = pieces_.parameters[static_cast<std::size_t>(index - 1)];
        return true;
    }

private:
    const Pieces& pieces_;
};

// The lengths wanted along an edge: `longest`, and near its ends those of its neighbours.
struct Lengths
{
    double longest, at_first, at_last, total;

    double at(double along) const
    {
        return std::min({longest, at_first + growth * along, at_last + growth * (total - along)});
    }
};

// Cuts every piece so that it has the lengths wanted; a piece of a curve is cut on the curve.
Pieces cut_shorter(const Pieces& coarse, const TopoDS_Edge& edge, const Lengths& wanted)
{
    const BRepAdaptor_Curve curve(edge);
    Pieces fine;
    fine.add(coarse.points.front(), coarse.parameters.front());
    double along = 0.0;
    for (std::size_t i = 0; i + 1 < coarse.points.size(); ++i)
    {
        constexpr int samples = 64;  // chosen: sizes that grow by 0.4 are integrated to 1 %
        const double length = coarse.length(i), step = length / samples;
        std::array<double, samples + 1> count{};  // of wanted pieces up to each sample
        for (std::size_t k = 0; k < samples; ++k)
            count[k + 1] =
                count[k] + step / wanted.at(along + (static_cast<double>(k) + 0.5) * step);
        const int pieces = static_cast<int>(std::ceil(count[samples] - 1e-6));
        const double from = coarse.parameters[i], to = coarse.parameters[i + 1];
        for (int cut = 1; cut < pieces; ++cut)
        {
            const double target = count[samples] * cut / pieces;
            const auto above = std::upper_bound(count.begin(), count.end(), target) - count.begin();
            const auto k = static_cast<std::size_t>(above - 1);
            const double part =
                (static_cast<double>(k) + (target - count[k]) / (count[k + 1] - count[k]))
                / samples;
            const double parameter = from + part * (to - from);
            fine.add(curve.Value(parameter), parameter);
        }
        fine.add(coarse.points[i + 1], to);
        along += length;
    }
    return fine;
}

// Tells BRepMesh to stop.
class Stop : public Message_ProgressIndicator
{
public:
    explicit Stop(const StopFlag* flag) : flag_(flag) {}

protected:
    Standard_Boolean UserBreak() override { return flag_ != nullptr && flag_->load(); }
    void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

private:
    const StopFlag* flag_;
};

// Cuts the edges of a model; takes the place of BRepMesh_EdgeDiscret, which knows no length.
class EdgeCutter : public IMeshTools_ModelAlgo
{
public:
    EdgeCutter(const CadMeshing& meshing, const StopFlag* stop) : meshing_(meshing), stop_(stop) {}

protected:
    Standard_Boolean performInternal(const Handle(IMeshData_Model) & model,
                                     const IMeshTools_Parameters& parameters,
                                     const Message_ProgressRange&) override
    {
        std::vector<Pieces> coarse(static_cast<std::size_t>(model->EdgesNb()));
        const auto for_each_edge = [&](const auto& work)
        {
            const auto guarded = [&](int index)
            {
                const IMeshData::IEdgeHandle& edge = model->GetEdge(index);
                if (stop_ != nullptr && stop_->load())
                    return;
                try
                {
                    work(edge, coarse[static_cast<std::size_t>(index)]);
                }
                catch (const Standard_Failure&)
                {
                    edge->SetStatus(IMeshData_Failure);
                }
            };
            OSD_Parallel::For(0, model->EdgesNb(), guarded, !parameters.InParallel);
        };
        for_each_edge([&](const IMeshData::IEdgeHandle& edge, Pieces& pieces)
                      { pieces = follow_curve(edge, parameters, model->GetMaxSize()); });
        if (stop_ != nullptr && stop_->load())
            return false;
        note_ends(*model, coarse);
        for_each_edge([&](const IMeshData::IEdgeHandle& edge, const Pieces& pieces)
                      { cut(edge, pieces); });
        return true;
    }

private:
    // The pieces that deflection and angle ask for.
    Pieces follow_curve(const IMeshData::IEdgeHandle& edge, const IMeshTools_Parameters& parameters,
                        double size) const
    {
        BRepMesh_Deflection::ComputeDeflection(edge, size, parameters);
        // The tessellator takes half of what it is told.
        edge->SetDeflection(2.0 * meshing_.deflection);
        edge->SetAngularDeflection(2.0 * meshing_.angle);
        for (int k = 0; k < edge->PCurvesNb(); ++k)
            BRepMesh_ShapeTool::CheckAndUpdateFlags(edge, edge->GetPCurve(k));
        Handle(IMeshTools_CurveTessellator) tessellator;
        if (edge->IsFree())
            tessellator = BRepMesh_EdgeDiscret::CreateEdgeTessellator(edge, parameters);
        else
        {
            const IMeshData::IPCurveHandle& first = edge->GetPCurve(0);
            tessellator = BRepMesh_EdgeDiscret::CreateEdgeTessellator(edge, first->GetOrientation(),
                                                                      first->GetFace(), parameters);
        }
        Pieces pieces;
        gp_Pnt point;
        double parameter = 0.0;
        const int count = tessellator->PointsNb();
        for (int i = 1; i <= count; ++i)
            if (tessellator->Value(i, point, parameter) || i == 1 || i == count)
                pieces.add(point, parameter);
        edge->SetDeflection(meshing_.deflection);
        return pieces;
    }

    // The shortest piece at every vertex of the shape.
    void note_ends(const IMeshData_Model& model, const std::vector<Pieces>& coarse)
    {
        for (int index = 0; index < model.EdgesNb(); ++index)
        {
            const Pieces& pieces = coarse[static_cast<std::size_t>(index)];
            const IMeshData::IEdgeHandle& edge = model.GetEdge(index);
            if (pieces.points.size() < 2 || edge->GetDegenerated())
                continue;
            TopoDS_Vertex first, last;
            TopExp::Vertices(edge->GetEdge(), first, last);
            note_end(first, pieces.length(0));
            note_end(last, pieces.length(pieces.points.size() - 2));
        }
    }

    void note_end(const TopoDS_Vertex& vertex, double length)
    {
        const int index = vertices_.Add(vertex);
        if (index > static_cast<int>(lengths_.size()))
            lengths_.push_back(meshing_.edge);
        double& shortest = lengths_[static_cast<std::size_t>(index - 1)];
        shortest = std::min(shortest, std::max(length, 1e-3 * meshing_.edge));
    }

    double length_at(const TopoDS_Vertex& vertex) const
    {
        const int index = vertices_.FindIndex(vertex);
        return index > 0 ? lengths_[static_cast<std::size_t>(index - 1)] : meshing_.edge;
    }

    void cut(const IMeshData::IEdgeHandle& edge, const Pieces& coarse) const
    {
        Pieces pieces = coarse;
        if (edge->GetSameParam() && !edge->GetDegenerated() && coarse.points.size() > 1)
        {
            TopoDS_Vertex first, last;
            TopExp::Vertices(edge->GetEdge(), first, last);
            double total = 0.0;
            for (std::size_t i = 0; i + 1 < coarse.points.size(); ++i)
                total += coarse.length(i);
            pieces = cut_shorter(coarse, edge->GetEdge(),
                                 {meshing_.edge, length_at(first), length_at(last), total});
        }
        const Handle(CutEdge) tessellator = new CutEdge(pieces);
        BRepMesh_EdgeDiscret::Tessellate3d(edge, tessellator, true);
        if (!edge->IsFree())
            BRepMesh_EdgeDiscret::Tessellate2d(edge, true);
    }

    CadMeshing meshing_;
    const StopFlag* stop_;
    TopTools_IndexedMapOfShape vertices_;
    std::vector<double> lengths_;
};

}  // namespace

void triangulate(const TopoDS_Shape& shape, const CadMeshing& meshing, const StopFlag* stop)
{
    BRepTools::Clean(shape);
    Handle(BRepMesh_Context) context = new BRepMesh_Context;
    context->SetEdgeDiscret(new EdgeCutter(meshing, stop));
    IMeshTools_Parameters& parameters = context->ChangeParameters();
    parameters.Deflection = meshing.deflection;
    parameters.Angle = meshing.angle;
    parameters.DeflectionInterior = meshing.deflection;
    parameters.AngleInterior = meshing.angle;
    parameters.MinSize = 1e-3 * meshing.edge;
    parameters.InParallel = true;
    BRepMesh_IncrementalMesh mesher;
    mesher.ChangeParameters() = parameters;
    TopoDS_Shape meshed = shape;
    mesher.SetShape(meshed);
    const Handle(Stop) indicator = new Stop(stop);
    mesher.Perform(context, indicator->Start());
    stop_if(stop);
}

}  // namespace sheetmorph::cad
