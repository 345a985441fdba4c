// SPDX-License-Identifier: BSD-3-Clause
#include "app/desktop/desktop_recent.h"

#include <optional>
#include <QDir>
#include <QDomDocument>
#include <QFile>
#include <QFileInfo>
#include <QMimeDatabase>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUrl>
#include <utility>

namespace relievo {
namespace {

constexpr qint64 kMostBytes = 16'000'000;
const char* const kOwner = "http://freedesktop.org";
const char* const kUs = "relievo";

QDomElement child(QDomDocument& list, QDomElement parent, const char* tag) {
  QDomElement found = parent.firstChildElement(QLatin1String(tag));
  if (found.isNull()) {
    found = list.createElement(QLatin1String(tag));
    parent.appendChild(found);
  }
  return found;
}

/// What freedesktop.org's programs say of a bookmark; null: they say nothing.
QDomElement metadataOf(const QDomElement& bookmark) {
  QDomElement found = bookmark.firstChildElement(QStringLiteral("info"))
                          .firstChildElement(QStringLiteral("metadata"));
  while (!found.isNull() && found.attribute(QStringLiteral("owner")) != QLatin1String(kOwner)) {
    found = found.nextSiblingElement(QStringLiteral("metadata"));
  }
  return found;
}

QDomElement usAmong(const QDomElement& applications) {
  QDomElement found = applications.firstChildElement(QStringLiteral("bookmark:application"));
  while (!found.isNull() && found.attribute(QStringLiteral("name")) != QLatin1String(kUs)) {
    found = found.nextSiblingElement(QStringLiteral("bookmark:application"));
  }
  return found;
}

QDomDocument emptyList() {
  QDomDocument list;
  list.setContent(QByteArrayLiteral(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<xbel version=\"1.0\""
      " xmlns:bookmark=\"http://www.freedesktop.org/standards/desktop-bookmarks\""
      " xmlns:mime=\"http://www.freedesktop.org/standards/shared-mime-info\"/>\n"));
  return list;
}

/// Nothing: it is not to be touched.
std::optional<QDomDocument> read(const QString& name) {
  const QFileInfo place(name);
  if (!place.exists() && !place.isSymLink()) return emptyList();
  QFile file(name);
  if (!place.isFile() || place.size() > kMostBytes || !file.open(QIODevice::ReadOnly)) {
    return std::nullopt;
  }
  QDomDocument list;
  const bool is_list = list.setContent(file.readAll(), false) &&
                       list.documentElement().tagName() == QLatin1String("xbel");
  return is_list ? std::optional(list) : std::nullopt;
}

void write(const QString& name, const QDomDocument& list) {
  if (!QDir().mkpath(QFileInfo(name).absolutePath())) return;
  QSaveFile file(name);
  if (!file.open(QIODevice::WriteOnly)) return;
  file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner);
  file.write(list.toByteArray(2));
  file.commit();
}

QDomElement bookmarkOf(const QDomDocument& list, const QString& address) {
  QDomElement found = list.documentElement().firstChildElement(QStringLiteral("bookmark"));
  while (!found.isNull() && found.attribute(QStringLiteral("href")) != address) {
    found = found.nextSiblingElement(QStringLiteral("bookmark"));
  }
  return found;
}

/// Where programs are named, of a bookmark that is there or becomes so.
QDomElement applicationsOf(QDomDocument& list, QDomElement bookmark, const QString& file) {
  QDomElement metadata = metadataOf(bookmark);
  if (metadata.isNull()) {
    metadata = list.createElement(QStringLiteral("metadata"));
    metadata.setAttribute(QStringLiteral("owner"), QLatin1String(kOwner));
    child(list, bookmark, "info").appendChild(metadata);
  }
  if (metadata.firstChildElement(QStringLiteral("mime:mime-type")).isNull()) {
    // By its name: what foreign files hold is read by import processes alone (docs/adr/0146).
    const QMimeType type = QMimeDatabase().mimeTypeForFile(file, QMimeDatabase::MatchExtension);
    child(list, metadata, "mime:mime-type").setAttribute(QStringLiteral("type"), type.name());
  }
  return child(list, metadata, "bookmark:applications");
}

}  // namespace

DesktopRecent::DesktopRecent(QString list) : list_(std::move(list)) {
  if (!list_.isEmpty()) return;
  list_ = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
          QStringLiteral("/recently-used.xbel");
}

void DesktopRecent::add(const QString& file, const QDateTime& now) const {
  std::optional<QDomDocument> list = read(list_);
  if (!list) return;
  const QString address = QString::fromLatin1(QUrl::fromLocalFile(file).toEncoded());
  const QString time = now.toUTC().toString(Qt::ISODate);
  QDomElement bookmark = bookmarkOf(*list, address);
  if (bookmark.isNull()) {
    bookmark = list->createElement(QStringLiteral("bookmark"));
    bookmark.setAttribute(QStringLiteral("href"), address);
    bookmark.setAttribute(QStringLiteral("added"), time);
    list->documentElement().appendChild(bookmark);
  }
  bookmark.setAttribute(QStringLiteral("modified"), time);
  bookmark.setAttribute(QStringLiteral("visited"), time);
  QDomElement applications = applicationsOf(*list, bookmark, file);
  QDomElement us = usAmong(applications);
  if (us.isNull()) {
    us = list->createElement(QStringLiteral("bookmark:application"));
    us.setAttribute(QStringLiteral("name"), QLatin1String(kUs));
    us.setAttribute(QStringLiteral("exec"), QStringLiteral("'relievo %f'"));
    applications.appendChild(us);
  }
  us.setAttribute(QStringLiteral("modified"), time);
  us.setAttribute(QStringLiteral("count"), us.attribute(QStringLiteral("count")).toInt() + 1);
  write(list_, *list);
}

void DesktopRecent::clear() const {
  std::optional<QDomDocument> list = read(list_);
  if (!list) return;
  QDomElement bookmark = list->documentElement().firstChildElement(QStringLiteral("bookmark"));
  bool is_changed = false;
  while (!bookmark.isNull()) {
    const QDomElement next = bookmark.nextSiblingElement(QStringLiteral("bookmark"));
    QDomElement applications =
        metadataOf(bookmark).firstChildElement(QStringLiteral("bookmark:applications"));
    const QDomElement us = usAmong(applications);
    if (!us.isNull()) {
      is_changed = true;
      applications.removeChild(us);
      if (applications.firstChildElement().isNull()) {
        list->documentElement().removeChild(bookmark);
      }
    }
    bookmark = next;
  }
  if (is_changed) write(list_, *list);
}

}  // namespace relievo
