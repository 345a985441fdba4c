<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_GB">
<context>
    <name>relievo::CloudView</name>
    <message numerus="yes">
        <source>%n corner(s) so far</source>
        <translation>
            <numerusform>%n corner so far</numerusform>
            <numerusform>%n corners so far</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>relievo::ForeignFiles</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 names %n file(s) outside of its folder that are not, by their checksums, what it was made from:</source>
        <translation>
            <numerusform>%1 names %n file outside of its folder that is not, by its checksum, what it was made from:</numerusform>
            <numerusform>%1 names %n files outside of its folder that are not, by their checksums, what it was made from:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>relievo::MeasurePanel</name>
    <message numerus="yes">
        <source>%n curve(s)</source>
        <translation>
            <numerusform>%n curve</numerusform>
            <numerusform>%n curves</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>relievo::OpenController</name>
    <message numerus="yes">
        <source>relievo ended unexpectedly. Work on %1 of %2 was kept (%n step(s)).</source>
        <translation>
            <numerusform>relievo ended unexpectedly. Work on %1 of %2 was kept (%n step).</numerusform>
            <numerusform>relievo ended unexpectedly. Work on %1 of %2 was kept (%n steps).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>relievo::PackageController</name>
    <message numerus="yes">
        <source>%1 is packed: %n file(s), each with its checksum</source>
        <translation>
            <numerusform>%1 is packed: %n file with its checksum</numerusform>
            <numerusform>%1 is packed: %n files, each with its checksum</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n part(s) of %1 are not as they were packed. Nothing was opened. &apos;relievo project verify&apos; names them.</source>
        <translation>
            <numerusform>%n part of %1 is not as it was packed. Nothing was opened. &apos;relievo project verify&apos; names it.</numerusform>
            <numerusform>%n parts of %1 are not as they were packed. Nothing was opened. &apos;relievo project verify&apos; names them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>relievo::PairPicking</name>
    <message numerus="yes">
        <source>%n pair(s). Escape or the button ends; more pairs do no harm.</source>
        <translation>
            <numerusform>%n pair. Escape or the button ends; more pairs do no harm.</numerusform>
            <numerusform>%n pairs. Escape or the button ends; more pairs do no harm.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>relievo::QuestionController</name>
    <message numerus="yes">
        <source>%n file(s) that this project names were not read. They stay named in it, and are offered for no package and no figure.</source>
        <translation>
            <numerusform>%n file that this project names was not read. It stays named in it, and is offered for no package and no figure.</numerusform>
            <numerusform>%n files that this project names were not read. They stay named in it, and are offered for no package and no figure.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>relievo::ReplayControl</name>
    <message numerus="yes">
        <source>The recording does not say where %n window(s) lay; they are shown around what was touched.</source>
        <translation>
            <numerusform>The recording does not say where %n window lay; it is shown around what was touched.</numerusform>
            <numerusform>The recording does not say where %n windows lay; they are shown around what was touched.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>relievo</name>
    <message numerus="yes">
        <source>Force interrupted %n time(s).</source>
        <translation>
            <numerusform>Force interrupted %n time.</numerusform>
            <numerusform>Force interrupted %n times.</numerusform>
        </translation>
    </message>
</context>
</TS>
