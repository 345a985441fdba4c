// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <string>
#include <string_view>

class QUrl;

namespace relievo {

// A file's name is bytes (docs/adr/0135-names-are-bytes.md). In Qt it is the text that
// core/provenance/name_text.h gives it, so that QFile, QDir and the file dialogs find every file.

/// Before the first name and the QApplication: from now on QFile::encodeName() and decodeName(),
/// and with them all of Qt, keep every byte of a name, in any locale. [GUI thread]
void keepBytesOfNames();

/// The very bytes of a path that Qt holds, and back.
std::string bytesOfPath(const QString& path);
QString pathFromBytes(std::string_view bytes);

/// The path of a file that was dropped; a URL may have bytes that are no UTF-8.
QString droppedPath(const QUrl& url);

/// Is this the address of a map on the web, and no path?
bool isAddress(const QString& name);
/// Of a map from the web, whose map.json is kept among the program's own files, its address; all
/// other paths as they are.
QString addressOrPath(const QString& path);
/// Where what is made of a file is offered a place: beside it; of a map from the web, at home.
QString folderFor(const QString& path);

/// Last name of a path, and all of it, for people: see core's escapedName(). Long names are
/// shortened. Of a map from the web it is its address.
QString shownName(const QString& path);
QString shownPath(const QString& path);
/// Last name as a line of a file keeps it: as above, never shortened.
QString wholeName(const QString& path);
/// All of it for a tool tip, which Qt would take for HTML if it looked like some.
QString shownAsTip(const QString& path);
/// Last name for a menu or a button, where "&" marks a key.
QString shownInMenu(const QString& path);

/// Last name of a path without its ending, for a name that `more` is put behind: short enough that
/// both together are one.
QString stemOf(const QString& path, const QString& more);

}  // namespace relievo
