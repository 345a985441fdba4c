// SPDX-License-Identifier: BSD-3-Clause
#include "app/desktop/desktop_recent.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QDomDocument>
#include <QFile>
#include <QTemporaryDir>

namespace relievo {
namespace {

class DesktopRecentTest : public ::testing::Test {
 protected:
  QString list() const { return folder_.filePath("data/recently-used.xbel"); }
  void write(const QByteArray& text) const {
    QDir(folder_.path()).mkpath("data");
    QFile file(list());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  }
  QByteArray text() const {
    QFile file(list());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  /// Addresses in it, in order.
  QStringList addresses() const {
    QDomDocument found;
    EXPECT_TRUE(found.setContent(text(), false)) << text().toStdString();
    QStringList all;
    const QDomNodeList bookmarks = found.elementsByTagName("bookmark");
    for (int i = 0; i < bookmarks.size(); ++i) {
      all << bookmarks.at(i).toElement().attribute("href");
    }
    return all;
  }
  /// What it says of an address for one program.
  QDomElement program(const QString& address, const QString& name) const {
    QDomDocument found;
    found.setContent(text(), false);
    const QDomNodeList programs = found.elementsByTagName("bookmark:application");
    for (int i = 0; i < programs.size(); ++i) {
      const QDomElement one = programs.at(i).toElement();
      const QDomElement bookmark =
          one.parentNode().parentNode().parentNode().parentNode().toElement();
      if (one.attribute("name") == name && bookmark.attribute("href") == address) return one;
    }
    return {};
  }

  QTemporaryDir folder_;
};

constexpr const char* kOfOthers =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<xbel version="1.0"
      xmlns:bookmark="http://www.freedesktop.org/standards/desktop-bookmarks"
      xmlns:mime="http://www.freedesktop.org/standards/shared-mime-info">
  <bookmark href="file:///srv/a/letter%20one.odt" added="2026-01-02T03:04:05.123456Z" modified="2026-01-02T03:04:05Z" visited="2026-01-02T03:04:05Z">
    <title>Müller &amp; Söhne</title>
    <info>
      <metadata owner="http://example.org"><own:thing xmlns:own="http://example.org">7</own:thing></metadata>
      <metadata owner="http://freedesktop.org">
        <mime:mime-type type="application/vnd.oasis.opendocument.text"/>
        <bookmark:groups><bookmark:group>Office</bookmark:group></bookmark:groups>
        <bookmark:applications>
          <bookmark:application name="Writer" exec="&apos;writer %u&apos;" modified="2026-01-02T03:04:05Z" count="3"/>
        </bookmark:applications>
      </metadata>
    </info>
  </bookmark>
</xbel>
)";

TEST_F(DesktopRecentTest, AFileIsAddedOnceWithWhoOpenedIt) {
  const DesktopRecent recent(list());
  recent.add("/scans/a coin 50 %/Münze.ply", QDateTime({2026, 11, 30}, {1, 2, 3}, Qt::UTC));
  recent.add("/scans/b.ply", QDateTime({2026, 11, 30}, {1, 3, 0}, Qt::UTC));
  recent.add("/scans/a coin 50 %/Münze.ply", QDateTime({2026, 11, 30}, {2, 0, 0}, Qt::UTC));
  const QString coin = "file:///scans/a%20coin%2050%20%25/M%C3%BCnze.ply";
  EXPECT_EQ(addresses(), (QStringList{coin, "file:///scans/b.ply"}));
  const QDomElement us = program(coin, "relievo");
  EXPECT_EQ(us.attribute("count"), "2");
  EXPECT_EQ(us.attribute("exec"), "'relievo %f'");
  EXPECT_EQ(us.attribute("modified"), "2026-11-30T02:00:00Z");
  EXPECT_TRUE(text().contains("added=\"2026-11-30T01:02:03Z\""));
  EXPECT_TRUE(text().contains("mime:mime-type"));
  EXPECT_EQ(QFile::permissions(list()) & (QFile::ReadGroup | QFile::ReadOther), 0)
      << "what somebody opened is nobody else's to read";
}

TEST_F(DesktopRecentTest, WhatOthersWroteStays) {
  write(kOfOthers);
  const DesktopRecent recent(list());
  recent.add("/scans/b.ply");
  recent.add("/srv/a/letter one.odt");  // Which somebody tried to open here.
  EXPECT_EQ(addresses().size(), 2);
  const QString letter = "file:///srv/a/letter%20one.odt";
  EXPECT_EQ(program(letter, "Writer").attribute("count"), "3");
  EXPECT_EQ(program(letter, "relievo").attribute("count"), "1");
  for (const char* part :
       {"Müller &amp; Söhne", "Office", "http://example.org", ">7<",
        "added=\"2026-01-02T03:04:05.123456Z\"", "application/vnd.oasis.opendocument.text"}) {
    EXPECT_TRUE(text().contains(part)) << part;
  }
  recent.clear();
  EXPECT_EQ(addresses(), QStringList{letter}) << "it is another program's, too";
  EXPECT_TRUE(program(letter, "relievo").isNull());
  EXPECT_EQ(program(letter, "Writer").attribute("count"), "3");
}

TEST_F(DesktopRecentTest, WhatIsNoListIsNotTouched) {
  const DesktopRecent recent(list());
  for (const char* other : {"", "<xbel version=\"1.0\"><bookmark", "<html/>", "no list"}) {
    write(other);
    recent.add("/scans/b.ply");
    recent.clear();
    EXPECT_EQ(text(), other);
  }
  ASSERT_TRUE(QFile::remove(list()));
  ASSERT_TRUE(QDir().mkpath(list()));  // As people do who want no such list.
  recent.add("/scans/b.ply");
  EXPECT_TRUE(QDir(list()).isEmpty());
}

}  // namespace
}  // namespace relievo
