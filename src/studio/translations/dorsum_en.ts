<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Removal</name>
    <message numerus="yes">
        <source>Its %n picture(s) are deleted for good. The next capture of this hand takes its number.</source>
        <translation>
            <numerusform>Its %n picture is deleted for good. The next capture of this hand takes its number.</numerusform>
            <numerusform>Its %n pictures are deleted for good. The next capture of this hand takes its number.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n capture(s), %1 together, are deleted for good. The id and what was said of the person go too. Exports, surfaces and backups are not reached.</source>
        <translation>
            <numerusform>%n capture, %1 together, is deleted for good. The id and what was said of the person go too. Exports, surfaces and backups are not reached.</numerusform>
            <numerusform>%n captures, %1 together, are deleted for good. The id and what was said of the person go too. Exports, surfaces and backups are not reached.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignDetails</name>
    <message numerus="yes">
        <source>%n capture(s) are missing in all.</source>
        <translation>
            <numerusform>%n capture is missing in all.</numerusform>
            <numerusform>%n captures are missing in all.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignModel</name>
    <message numerus="yes">
        <source>Removed the person and %n capture(s). Exports, surfaces and backups are not reached.</source>
        <translation>
            <numerusform>Removed the person and %n capture. Exports, surfaces and backups are not reached.</numerusform>
            <numerusform>Removed the person and %n captures. Exports, surfaces and backups are not reached.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Verified: all %n file(s) are as they were stored.</source>
        <translation>
            <numerusform>Verified: the %n file is as it was stored.</numerusform>
            <numerusform>Verified: all %n files are as they were stored.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Verified: the campaign is not as it was stored, with %n finding(s). Bring back what is missing or damaged from a copy of the folder, or remove the capture and take it again.</source>
        <translation>
            <numerusform>Verified: the campaign is not as it was stored, with %n finding. Bring back what is missing or damaged from a copy of the folder, or remove the capture and take it again.</numerusform>
            <numerusform>Verified: the campaign is not as it was stored, with %n findings. Bring back what is missing or damaged from a copy of the folder, or remove the capture and take it again.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignPage</name>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n person</numerusform>
            <numerusform>%n people</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dorsum::StagesPage</name>
    <message numerus="yes">
        <source>The last change of the parameters changed %n picture(s); a dot marks them in the list.</source>
        <translation>
            <numerusform>The last change of the parameters changed %n picture; a dot marks it in the list.</numerusform>
            <numerusform>The last change of the parameters changed %n pictures; a dot marks them in the list.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dorsum::SurfacePage</name>
    <message numerus="yes">
        <source>%Ln point(s)</source>
        <translation>
            <numerusform>%Ln point</numerusform>
            <numerusform>%Ln points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln triangle</numerusform>
            <numerusform>%Ln triangles</numerusform>
        </translation>
    </message>
</context>
</TS>
