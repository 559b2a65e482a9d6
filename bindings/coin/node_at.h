// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Inventor/nodes/SoNode.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace sheetmorph::coin
{

//! The node at an address as pivy gives it, int(node.this).
//! \throws std::invalid_argument if it is none of that type
template <typename Node>
Node* node_at(std::uintptr_t address)
{
    auto* node = reinterpret_cast<SoNode*>(address);
    if (node == nullptr || !node->isOfType(Node::getClassTypeId()))
        throw std::invalid_argument(std::string("expected the address of a Coin node of type ")
                                    + Node::getClassTypeId().getName().getString());
    return static_cast<Node*>(node);
}

}  // namespace sheetmorph::coin
