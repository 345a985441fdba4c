// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/file_names.h"

#include <algorithm>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTextCodec>
#include <QTextDocument>
#include <QUrl>

#include "core/io/web/published_map.h"
#include "core/io/web/web_link.h"
#include "core/provenance/name_text.h"
#include "core/tiles/published/published_tiles.h"

namespace relievo {
namespace {

constexpr int kMostNameBytes = 255;  // Of Linux's file systems.

/// UTF-8, in which bytes that are none keep a character each. Qt asks the locale's codec for every
/// name of a file, and its own would lose them.
class NameCodec : public QTextCodec {
 public:
  QByteArray name() const override { return QByteArrayLiteral("relievo-names"); }
  int mibEnum() const override { return -1350; }  // None of IANA's.

 protected:
  QString convertToUnicode(const char* text, int length, ConverterState* state) const override {
    QByteArray bytes;
    if (state != nullptr && state->remainingChars > 0) {
      for (int i = 0; i < state->remainingChars; ++i) {
        bytes += static_cast<char>(state->state_data[0] >> (8U * static_cast<unsigned>(i)));
      }
      state->remainingChars = 0;
    }
    bytes.append(text, length);
    if (state != nullptr) keepBegun(bytes, *state);
    return QString::fromStdString(
        textOfName({bytes.constData(), static_cast<std::size_t>(bytes.size())}));
  }
  QByteArray convertFromUnicode(const QChar* text, int length, ConverterState*) const override {
    const QByteArray utf8 = QString::fromRawData(text, length).toUtf8();
    return QByteArray::fromStdString(
        nameFromText({utf8.constData(), static_cast<std::size_t>(utf8.size())}));
  }

 private:
  /// Of a text in pieces, a character may be begun at the end of one.
  static void keepBegun(QByteArray& bytes, ConverterState& state) {
    for (int i = 1; i <= std::min(3, bytes.size()); ++i) {
      const auto byte = static_cast<unsigned char>(bytes[bytes.size() - i]);
      if (byte < 0x80) return;
      if (byte < 0xC0) continue;
      const int whole = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
      if (whole <= i) return;
      state.state_data[0] = 0;
      for (int k = 0; k < i; ++k) {
        const auto kept = static_cast<unsigned char>(bytes[bytes.size() - i + k]);
        state.state_data[0] |= unsigned{kept} << (8U * static_cast<unsigned>(k));
      }
      state.remainingChars = i;
      bytes.chop(i);
      return;
    }
  }
};

QString escaped(const QString& name) {
  return QString::fromStdString(escapedName(bytesOfPath(name)));
}

/// All of an address but its scheme: several have the same last name.
QString nameIn(const QString& path) {
  const QString place = addressOrPath(path);
  return isAddress(place) ? place.section(QLatin1String("://"), 1) : QFileInfo(path).fileName();
}

/// A name without a blank widens what shows it, so that a long one misses its middle.
QString shown(const QString& name) {
  constexpr int kMostCharacters = 80, kAtEnd = 25;
  QString text = escaped(name);
  if (text.size() <= kMostCharacters) return text;
  return text.left(kMostCharacters - kAtEnd - 1) + QChar(0x2026) + text.right(kAtEnd);
}

}  // namespace

void keepBytesOfNames() {
  // Qt owns its codecs, and has one of each name.
  QTextCodec* codec = QTextCodec::codecForName("relievo-names");
  QTextCodec::setCodecForLocale(codec != nullptr ? codec : new NameCodec);
}

std::string bytesOfPath(const QString& path) {
  return QFile::encodeName(path).toStdString();
}

QString pathFromBytes(std::string_view bytes) {
  return QFile::decodeName(QByteArray(bytes.data(), static_cast<int>(bytes.size())));
}

QString droppedPath(const QUrl& url) {
  return QFile::decodeName(
      QByteArray::fromPercentEncoding(url.path(QUrl::FullyEncoded).toLatin1()));
}

bool isAddress(const QString& name) {
  return isWebAddress(bytesOfPath(name));
}

QString addressOrPath(const QString& path) {
  // Few files have the name; only of these their place is looked at.
  if (!path.endsWith(QLatin1String(kPublishedName)) || isAddress(path)) return path;
  const std::string address = addressOfKeptMap(bytesOfPath(path));
  return address.empty() ? path : pathFromBytes(address);
}

QString folderFor(const QString& path) {
  return isAddress(addressOrPath(path)) ? QDir::homePath() : QFileInfo(path).absolutePath();
}

QString shownName(const QString& path) {
  return shown(nameIn(path));
}

QString shownPath(const QString& file) {
  const QString path = addressOrPath(file);
  QStringList names = QDir::toNativeSeparators(path).split(QDir::separator());
  for (QString& name : names) name = shown(name);
  return names.join(QDir::separator());
}

QString wholeName(const QString& path) {
  return escaped(nameIn(path));
}

QString shownAsTip(const QString& path) {
  const QString text = escaped(QDir::toNativeSeparators(addressOrPath(path)));
  return Qt::mightBeRichText(text) ? Qt::convertFromPlainText(text) : text;
}

QString shownInMenu(const QString& path) {
  return shownName(path).replace('&', QLatin1String("&&"));
}

QString stemOf(const QString& path, const QString& more) {
  const QString place = addressOrPath(path);
  // An address has no ending, and its ":" stands in no name of other systems.
  QString stem = isAddress(place)
                     ? place.section('/', -1, -1, QString::SectionSkipEmpty).replace(':', '-')
                     : QFileInfo(path).completeBaseName();
  const int room = kMostNameBytes - QFile::encodeName(more).size();
  while (!stem.isEmpty() && QFile::encodeName(stem).size() > room) stem.chop(1);
  if (!stem.isEmpty() && stem.at(stem.size() - 1).isHighSurrogate()) stem.chop(1);
  return stem;
}

}  // namespace relievo
