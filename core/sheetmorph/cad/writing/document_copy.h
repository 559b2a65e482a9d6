// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_source.h"
#include "sheetmorph/cad/carry/carried_shape.h"
#include "sheetmorph/cad/label_attributes.h"

#include <map>

namespace sheetmorph::cad
{

//! A body of a document in its new form.
struct NewBody
{
    int variant = 0;  //!< equal for bodies that are equal in the new document
    const CarriedShape* carried =
        nullptr;  //!< in the coordinates of the body without its placement
};

//! The document of a source with new bodies: one product for each old one, or several if its
//! instances differ.
class DocumentCopy
{
public:
    //! \param bodies  one for each of source.bodies
    DocumentCopy(const CadSource& source, const std::vector<NewBody>& bodies);

    CadDocument& document() { return document_; }

private:
    using Key = std::pair<std::string, std::vector<int>>;

    void copy_root(const TDF_Label& root);
    TDF_Label copied(const TDF_Label& product, const Key& key);
    TDF_Label made(const TDF_Label& product);
    TDF_Label new_product(const TDF_Label& product);
    Key key_of(const TDF_Label& product) const;
    int product_count(const TDF_Label& product) const;
    void name_faces(const TDF_Label& product, const TopoDS_Shape& body,
                    const std::vector<FaceTag>& tags, const PartImages& images) const;
    std::string name_for(const TDF_Label& product, const std::string& entry);

    const CadSource& source_;
    const std::vector<NewBody>& bodies_;
    CadDocument document_;
    std::vector<std::pair<std::size_t, std::size_t>> ranges_;  // of bodies, by product
    std::size_t next_ = 0;                                     // product
    std::map<Key, TDF_Label> known_;
    std::map<std::string, int> uses_;
};

}  // namespace sheetmorph::cad
