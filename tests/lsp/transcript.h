#pragma once

#include <string>
#include <string_view>

namespace texbrdf::test {

/// Plays a transcript against a server in this process and writes it anew, with what the server really said. A
/// transcript that holds is unchanged. Lines:
///
///     # comment
///     client {…}                       `-> initialize {…}`, of whose answer only the encoding is shown
///     open a.tex                       didOpen with version 1, of a.md as Markdown; the text follows, each line behind
///     `| `
///     | \begin{equation}
///     change a.tex 2:3-2:4 "text"      didChange; the text is a JSON string; `change a.tex "text"` replaces all
///     -> method {…}                    a request, or a notification where the protocol says so
///     +> method {…}                    the same, in one write with the message before; `+ open`, `+ change` too
///     reply 1 {…}                      the result of the server's request with the id 1
///     file a.tex                       a file on the disk, in a folder of the test's own, before what follows; with
///     text remove a.tex                     it is gone link a.tex target                a symbolic link raw "bytes"
///     bytes as they are, a JSON string frame "body"                     a body with a correct header
///     <- …                             what the server sent
///
/// The folder is `file:///work`; what lies beside it is outside. In `{…}`, `"doc": "a.tex"` stands for `textDocument`,
/// and `"at": "2:3"` for `position`, counted from 1. In what the server sent, ranges are written `2:3-2:9`, URIs
/// without their folder, and `jsonrpc` is left out. Previews have values but no pictures, which come when they are
/// ready.
std::string play(std::string_view transcript);

}  // namespace texbrdf::test
