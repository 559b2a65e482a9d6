// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sheetmorph
{

//! An entry of an assembly that a message is about: kind "handle", name "tip".
struct Subject
{
    std::string kind;
    std::string name;

    bool operator==(const Subject& other) const { return kind == other.kind && name == other.name; }
};

//! A message with its subjects and its vertices, so that no reader has to parse them.
class Text
{
public:
    Text(const char* text) : Text(std::string(text)) {}
    Text(const std::string& text);

    //! "handle 'tip'", about that entry.
    static Text about(const std::string& kind, const std::string& name);

    //! Text about several entries, "contact 'a' and 'b'".
    static Text about(const std::string& shown, const std::vector<Subject>& subjects);

    //! "vertices 3, 7 and 5 more" if `before` is "vertices "; in short "7 vertices".
    static Text listed(const std::string& before, const std::vector<int>& vertices);

    //! "7 vertices (3, 7 and 5 more)"; in short "7 vertices".
    static Text counted(const std::vector<int>& vertices);

    //! Different words for full() and brief().
    static Text shortened(const std::string& full, const std::string& brief);

    Text& operator+=(const Text& more);
    friend Text operator+(Text text, const Text& more) { return std::move(text += more); }

    bool is_empty() const { return pieces_.empty(); }

    //! The whole message, with the numbers of its vertices.
    //! \param ids  (n) the number of every vertex; empty if they are the indices
    std::string full(const std::vector<int>& ids = {}) const;

    //! The message with the count of its vertices in place of their numbers.
    std::string brief() const;

    //! The subjects of the message in order, each once.
    const std::vector<Subject>& subjects() const { return subjects_; }

    //! The vertices that the message lists, indices.
    std::vector<int> vertices() const;

private:
    //! Words, or vertices between words.
    struct Piece
    {
        std::string before;
        std::vector<int> vertices;
        std::string after;
        std::string brief;
    };

    Text() = default;

    std::vector<Piece> pieces_;
    std::vector<Subject> subjects_;
};

//! "3, 7, 12 and 5 more": the first ids of a list, for messages.
std::string list_ids(const std::vector<int>& ids, std::size_t shown = 8);

}  // namespace sheetmorph
