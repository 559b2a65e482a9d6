// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/writing/document_copy.h"
#include "sheetmorph/cad/label_attributes.h"

#include <BRep_Builder.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDF_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

namespace sheetmorph::cad
{

namespace
{

using Images = TopTools_DataMapOfShapeShape;

std::string entry_of(const TDF_Label& label)
{
    TCollection_AsciiString entry;
    TDF_Tool::Entry(label, entry);
    return entry.ToCString();
}

TDF_Label product_of(const TDF_Label& label)
{
    TDF_Label product = label;
    if (XCAFDoc_ShapeTool::IsReference(label))
        XCAFDoc_ShapeTool::GetReferredShape(label, product);
    return product;
}

// Records the images of all parts of a placed body, with the same placement.
void note_images(PartImages& images, const TopoDS_Shape& body, const CarriedShape& carried)
{
    const TopLoc_Location place = body.Location();
    TopTools_IndexedMapOfShape before;
    TopExp::MapShapes(body.Located(TopLoc_Location()), before);
    for (int i = 1; i <= before.Extent(); ++i)
        if (carried.image.IsBound(before(i)))
            images.one.Bind(before(i).Moved(place), carried.image.Find(before(i)).Moved(place));
    for (const auto& [whole, washer] : carried.washers)
        images.washers.emplace_back(whole.Moved(place), washer.Moved(place));
}

// The shape with images in place of bodies; without free faces.
TopoDS_Shape rebuilt(const TopoDS_Shape& shape, const Images& images)
{
    if (images.IsBound(shape))
        return images.Find(shape).Oriented(shape.Orientation());
    if (shape.ShapeType() > TopAbs_FACE)
        return shape;
    if (shape.ShapeType() > TopAbs_COMPSOLID)
        return {};
    TopoDS_Compound made;
    const BRep_Builder builder;
    builder.MakeCompound(made);
    for (TopoDS_Iterator it(shape); it.More(); it.Next())
        if (const TopoDS_Shape part = rebuilt(it.Value(), images); !part.IsNull())
            builder.Add(made, part);
    return made;
}

// A shape, which may be null, together with sewn shells.
TopoDS_Shape with_shells(const TopoDS_Shape& shape, const std::vector<TopoDS_Shape>& sewn)
{
    const bool is_empty = shape.IsNull() || TopoDS_Iterator(shape).More() == false;
    if (is_empty && sewn.size() == 1)
        return sewn.front();
    TopoDS_Shape whole = shape;
    const BRep_Builder builder;
    if (shape.IsNull())
    {
        TopoDS_Compound made;
        builder.MakeCompound(made);
        whole = made;
    }
    for (const TopoDS_Shape& shell : sewn)
        builder.Add(whole, shell);
    return whole;
}

}  // namespace

DocumentCopy::DocumentCopy(const CadSource& source, const std::vector<NewBody>& bodies)
    : source_(source), bodies_(bodies)
{
    for (std::size_t k = 0; k < source.bodies.size(); ++k)
    {
        const auto product = static_cast<std::size_t>(source.bodies[k].product);
        ranges_.resize(std::max(ranges_.size(), product + 1), {k, k});
        ranges_[product].second = k + 1;
    }
    TDF_LabelSequence roots;
    source.document.shapes()->GetFreeShapes(roots);
    for (int i = 1; i <= roots.Length(); ++i)
        copy_root(roots.Value(i));
    document_.shapes()->UpdateAssemblies();
}

// Copies a root that is a placed product as such.
void DocumentCopy::copy_root(const TDF_Label& root)
{
    const TDF_Label product = made(product_of(root));
    if (product.IsNull() || !XCAFDoc_ShapeTool::IsReference(root))
        return;
    const TopoDS_Shape placed =
        XCAFDoc_ShapeTool::GetShape(product).Moved(XCAFDoc_ShapeTool::GetLocation(root));
    const TDF_Label label = document_.shapes()->AddShape(placed, false, false);
    copy_attributes(root, label);
    set_name(label, name_of(root));
}

int DocumentCopy::product_count(const TDF_Label& product) const
{
    if (!XCAFDoc_ShapeTool::IsAssembly(product))
        return 1;
    int count = 0;
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(product, components);
    for (int i = 1; i <= components.Length(); ++i)
        count += product_count(product_of(components.Value(i)));
    return count;
}

// A product, and the variants of its next bodies.
DocumentCopy::Key DocumentCopy::key_of(const TDF_Label& product) const
{
    Key key;
    key.first = entry_of(product);
    const std::size_t end =
        std::min(ranges_.size(), next_ + static_cast<std::size_t>(product_count(product)));
    for (std::size_t k = next_; k < end; ++k)
        for (std::size_t body = ranges_[k].first; body < ranges_[k].second; ++body)
            key.second.push_back(bodies_[body].variant);
    return key;
}

TDF_Label DocumentCopy::made(const TDF_Label& product)
{
    const Key key = key_of(product);
    const auto found = known_.find(key);
    if (found == known_.end())
        return known_[key] = copied(product, key);
    next_ += static_cast<std::size_t>(product_count(product));
    return found->second;
}

TDF_Label DocumentCopy::copied(const TDF_Label& product, const Key& key)
{
    if (!XCAFDoc_ShapeTool::IsAssembly(product))
        return new_product(product);
    const TDF_Label assembly = document_.shapes()->NewShape();
    copy_attributes(product, assembly);
    set_name(assembly, name_for(product, key.first));
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(product, components);
    for (int i = 1; i <= components.Length(); ++i)
    {
        const TDF_Label& old = components.Value(i);
        const TDF_Label part = made(product_of(old));
        if (part.IsNull())
            continue;
        const TDF_Label component =
            document_.shapes()->AddComponent(assembly, part, XCAFDoc_ShapeTool::GetLocation(old));
        copy_attributes(old, component);
        if (const std::string name = name_of(old); !name.empty())
            set_name(component, name);
    }
    return assembly;
}

void DocumentCopy::name_faces(const TDF_Label& product, const TopoDS_Shape& body,
                              const std::vector<FaceTag>& tags, const PartImages& images) const
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(body, TopAbs_FACE, faces);
    for (int f = 1; f <= std::min(faces.Extent(), static_cast<int>(tags.size())); ++f)
        if (const std::string& name = tags[static_cast<std::size_t>(f - 1)].name; !name.empty())
            for (const TopoDS_Shape& image : images.of(faces(f)))
                if (const TDF_Label label = document_.shapes()->AddSubShape(product, image);
                    !label.IsNull())
                    set_name(label, name);
}

TDF_Label DocumentCopy::new_product(const TDF_Label& product)
{
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
    const std::size_t index = next_++;
    if (index >= ranges_.size())
        return {};
    PartImages images;
    Images faces;
    std::vector<TopoDS_Shape> sewn;
    const auto [first, last] = ranges_[index];
    // The bodies are placed in the assembly; in the product, its shape places them.
    const auto inside = [&](const TopoDS_Shape& part, std::size_t body)
    { return part.Moved(source_.bodies[body].placement.Inverted()); };
    for (std::size_t k = first; k < last; ++k)
    {
        const NamedShape& body = source_.bodies[k];
        note_images(images, inside(body.shape, k), *bodies_[k].carried);
        for (const auto& [old, there] : body.sewn)
            faces.Bind(inside(old, k), images.one.Find(inside(there, k)));
        if (!body.sewn.empty())
            sewn.push_back(images.one.Find(inside(body.shape, k)));
    }
    const TopoDS_Shape whole = with_shells(rebuilt(shape, images.one), sewn);
    for (Images::Iterator it(faces); it.More(); it.Next())
        images.one.Bind(it.Key(), it.Value());
    const TDF_Label made = document_.shapes()->AddShape(whole, false, false);
    copy_attributes(product, made);
    set_name(made, name_for(product, entry_of(product)));
    copy_parts(product, made, images, document_.shapes());
    for (std::size_t k = first; k < last; ++k)
        name_faces(made, inside(source_.bodies[k].shape, k), source_.bodies[k].faces, images);
    for (std::size_t k = first; k < last && last - first > 1; ++k)
        if (const std::string& name = source_.bodies[k].own_name; !name.empty())
            if (const TDF_Label label = document_.shapes()->AddSubShape(
                    made, images.one.Find(inside(source_.bodies[k].shape, k)));
                !label.IsNull())
                set_name(label, name);
    return made;
}

std::string DocumentCopy::name_for(const TDF_Label& product, const std::string& entry)
{
    const std::string name = name_of(product);
    const int use = ++uses_[entry];
    return use == 1 || name.empty() ? name : name + " " + std::to_string(use);
}

}  // namespace sheetmorph::cad
