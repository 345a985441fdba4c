// SPDX-License-Identifier: BSD-3-Clause
// A Qt plugin that is not one of ours.
#include <QObject>

namespace relievo::test {

class ForeignPlugin : public QObject {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID "org.example.Foreign/7")
};

}  // namespace relievo::test

#include "foreign_plugin.moc"
