// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/contacts/contact_patches.h"
#include "sheetmorph/recognise/contacts/part_pairs.h"

#include <map>
#include <utility>

namespace sheetmorph::recognise
{

//! Combines bolts, connecting elements and near surfaces into the contacts of each pair of parts.
class ContactCollector
{
public:
    //! Keeps references to its arguments.
    //! \param tolerances  with a gap >= 0
    ContactCollector(const std::vector<ContactPart>& parts, const std::vector<PartShape>& shapes,
                     const ContactTolerances& tolerances);

    //! Adds the elements between two parts. Elements of one joint, and joints that share a vertex,
    //! become one contact.
    //! \param longest  mm; longer elements are skipped unless they belong to a rigid body
    void take_connections(const std::vector<Connection>& connections, double longest);

    void take_bolts(const std::vector<Bolt>& bolts);

    //! Adds the patches where the surfaces of two parts touch. found() turns a patch with flexible
    //! elements into a seam weld.
    void take_pair(int a, int b);

    std::vector<FoundContact> found();

private:
    using Pair = std::pair<int, int>;

    FoundContact contact_of(const Patch& patch, const Pair& pair) const;
    bool is_on_flanges(const FoundContact& contact) const;
    bool is_all_bolts(const FoundContact& contact) const;
    void add_connected(std::vector<FoundContact>& contacts, const Pair& pair);
    std::vector<FoundContact> welds_of(const Pair& pair) const;
    void join_pair(std::vector<FoundContact>& contacts) const;
    void measure(FoundContact& contact) const;

    const std::vector<ContactPart>& parts_;
    const std::vector<PartShape>& shapes_;
    const ContactTolerances& tolerances_;
    std::map<Pair, std::vector<Connection>> connected_;  // the first part is part_a
    std::map<Pair, std::vector<FoundContact>> bolted_;
    std::map<Pair, std::vector<FoundContact>> found_;
};

}  // namespace sheetmorph::recognise
