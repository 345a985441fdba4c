<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hi_IN">
<context>
    <name>AccessibleWidgets</name>
    <message>
        <source>Clear</source>
        <translation>मिटाएँ</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>और औज़ार</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>Checksum</source>
        <translation>चेकसम</translation>
    </message>
    <message>
        <source>Depth map</source>
        <translation>गहराई मानचित्र</translation>
    </message>
    <message>
        <source>Drawing the depth buffer</source>
        <translation>गहराई बफ़र बन रहा है</translation>
    </message>
    <message>
        <source>Filling gaps</source>
        <translation>अंतराल भरे जा रहे हैं</translation>
    </message>
    <message>
        <source>Filling holes</source>
        <translation>छेद भरे जा रहे हैं</translation>
    </message>
    <message>
        <source>Heights of cells</source>
        <translation>सेलों की ऊँचाइयाँ</translation>
    </message>
    <message>
        <source>Looking for gaps</source>
        <translation>अंतराल खोजे जा रहे हैं</translation>
    </message>
    <message>
        <source>Looking through gaps</source>
        <translation>अंतरालों के पार देखा जा रहा है</translation>
    </message>
    <message>
        <source>Measuring the scan</source>
        <translation>स्कैन मापा जा रहा है</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>तस्वीर</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>पिरामिड</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>रिकॉर्डिंग</translation>
    </message>
    <message>
        <source>Sorting points into tiles</source>
        <translation>बिंदु खंडों में बाँटे जा रहे हैं</translation>
    </message>
    <message>
        <source>Writing levels</source>
        <translation>स्तर लिखे जा रहे हैं</translation>
    </message>
    <message>
        <source>checking pages</source>
        <translation>पन्ने जाँचे जा रहे हैं</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>खुल रहा है</translation>
    </message>
    <message>
        <source>reading mesh</source>
        <translation>जाल पढ़ा जा रहा है</translation>
    </message>
    <message>
        <source>reading points</source>
        <translation>बिंदु पढ़े जा रहे हैं</translation>
    </message>
    <message>
        <source>front-most point</source>
        <translation>सबसे आगे का बिंदु</translation>
    </message>
    <message>
        <source>second point from the front</source>
        <translation>आगे से दूसरा बिंदु</translation>
    </message>
    <message>
        <source>mean of the top layer</source>
        <translation>ऊपरी परत का औसत</translation>
    </message>
    <message>
        <source>rear-most point</source>
        <translation>सबसे पीछे का बिंदु</translation>
    </message>
    <message>
        <source>median of the points</source>
        <translation>बिंदुओं का माध्यक</translation>
    </message>
    <message>
        <source>mean of the points</source>
        <translation>बिंदुओं का औसत</translation>
    </message>
    <message>
        <source>bilinear splat</source>
        <translation>द्विरैखिक वितरण</translation>
    </message>
    <message>
        <source>local quadratic</source>
        <translation>स्थानीय द्विघात सतह</translation>
    </message>
    <message>
        <source>length</source>
        <translation>लंबाई</translation>
    </message>
    <message>
        <source>length on the map</source>
        <translation>मानचित्र पर लंबाई</translation>
    </message>
    <message>
        <source>height range</source>
        <translation>ऊँचाई का विस्तार</translation>
    </message>
    <message>
        <source>along the surface</source>
        <translation>सतह के साथ</translation>
    </message>
    <message>
        <source>area in the view</source>
        <translation>दृश्य में क्षेत्रफल</translation>
    </message>
    <message>
        <source>volume above the plane</source>
        <translation>तल के ऊपर आयतन</translation>
    </message>
    <message>
        <source>area of the surface</source>
        <translation>सतह का क्षेत्रफल</translation>
    </message>
    <message>
        <source>height</source>
        <translation>ऊँचाई</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>दूरी</translation>
    </message>
    <message>
        <source>depth difference</source>
        <translation>गहराई का अंतर</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>कोण</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>ढाल</translation>
    </message>
    <message>
        <source>local relief</source>
        <translation>स्थानीय उभार</translation>
    </message>
    <message>
        <source>sky-view factor</source>
        <translation>आकाश-दृश्य गुणांक</translation>
    </message>
    <message>
        <source>openness</source>
        <translation>खुलापन</translation>
    </message>
    <message>
        <source>hillshade</source>
        <translation>पहाड़ी छाया</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>धूसर</translation>
    </message>
    <message>
        <source>viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>बंद करें</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>रद्द करें</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>सहेजें</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>ठीक</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>चित्र</translation>
    </message>
    <message>
        <source>Caption</source>
        <translation>चित्र-शीर्षक</translation>
    </message>
    <message>
        <source>hillshade, four lights</source>
        <translation>पहाड़ी छाया, चार प्रकाश</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>छोड़ दें</translation>
    </message>
    <message>
        <source>batlow</source>
        <translation>Batlow</translation>
    </message>
    <message>
        <source>length of the cut</source>
        <translation>काट की लंबाई</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>वीडियो</translation>
    </message>
    <message>
        <source>reading heights</source>
        <translation>ऊँचाइयाँ पढ़ना</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>रंग</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>तैयार किया जा रहा है</translation>
    </message>
    <message>
        <source>Writing the scan</source>
        <translation>स्कैन लिखा जा रहा है</translation>
    </message>
    <message>
        <source>multi-scale deviation</source>
        <translation>बहु-पैमाना विचलन</translation>
    </message>
    <message>
        <source>multi-scale curvature</source>
        <translation>बहु-पैमाना वक्रता</translation>
    </message>
    <message>
        <source>ambient occlusion</source>
        <translation>परिवेशी अवरोधन</translation>
    </message>
    <message>
        <source>proxy</source>
        <translation>प्रॉक्सी</translation>
    </message>
    <message>
        <source>force</source>
        <translation>बल</translation>
    </message>
    <message>
        <source>Finding the front</source>
        <translation>सामने की परत ढूँढना</translation>
    </message>
    <message>
        <source>Laying the scans on each other</source>
        <translation>स्कैन एक दूसरे पर रखना</translation>
    </message>
    <message>
        <source>Looking at colours</source>
        <translation>रंग देखना</translation>
    </message>
    <message>
        <source>Looking at the scans</source>
        <translation>स्कैन देखना</translation>
    </message>
    <message>
        <source>Opening the files</source>
        <translation>फ़ाइलें खोलना</translation>
    </message>
    <message>
        <source>Publishing</source>
        <translation>प्रकाशित करना</translation>
    </message>
    <message>
        <source>Searching where the scans meet</source>
        <translation>स्कैन कहाँ मिलते हैं, यह ढूँढना</translation>
    </message>
    <message>
        <source>Solving all poses together</source>
        <translation>सभी स्थितियाँ एक साथ निकालना</translation>
    </message>
    <message>
        <source>Sorting colours into tiles</source>
        <translation>रंग टाइलों में बाँटना</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>लिखना</translation>
    </message>
    <message>
        <source>Writing colours</source>
        <translation>रंग लिखना</translation>
    </message>
    <message>
        <source>reading pictures</source>
        <translation>चित्र पढ़ना</translation>
    </message>
    <message>
        <source>Fetching the map</source>
        <translation>मानचित्र लाया जा रहा है</translation>
    </message>
    <message>
        <source>HIP</source>
        <translation>HIP</translation>
    </message>
</context>
<context>
    <name>Event</name>
    <message>
        <source>%1 samples dropped before this one</source>
        <translation>इससे पहले %1 नमूने छूटे</translation>
    </message>
    <message>
        <source>resumed after %1 ms</source>
        <translation>%1 ms बाद फिर शुरू</translation>
    </message>
    <message>
        <source>stiffness %1 N/m</source>
        <translation>कठोरता %1 N/m</translation>
    </message>
    <message>
        <source>softened against swinging</source>
        <translation>कंपन के विरुद्ध नरम किया</translation>
    </message>
    <message>
        <source>forces off</source>
        <translation>बल बंद</translation>
    </message>
    <message>
        <source>forces wait for a clear hand</source>
        <translation>बल हाथ के सतह से हटने की प्रतीक्षा में</translation>
    </message>
    <message>
        <source>forces rise</source>
        <translation>बल बढ़ रहे हैं</translation>
    </message>
    <message>
        <source>forces on</source>
        <translation>बल चालू</translation>
    </message>
    <message>
        <source>button %1 down</source>
        <translation>बटन %1 दबा</translation>
    </message>
    <message>
        <source>button %1 up</source>
        <translation>बटन %1 छूटा</translation>
    </message>
    <message>
        <source>no fault</source>
        <translation>कोई गड़बड़ी नहीं</translation>
    </message>
    <message>
        <source>the device did not answer in time</source>
        <translation>उपकरण ने समय पर उत्तर नहीं दिया</translation>
    </message>
    <message>
        <source>the device was unplugged</source>
        <translation>उपकरण निकाल दिया गया</translation>
    </message>
    <message>
        <source>the device sent something unreadable</source>
        <translation>उपकरण ने अपठनीय कुछ भेजा</translation>
    </message>
    <message>
        <source>the device is too hot</source>
        <translation>उपकरण बहुत गर्म है</translation>
    </message>
    <message>
        <source>the device reported an impossible position</source>
        <translation>उपकरण ने असंभव स्थिति बताई</translation>
    </message>
    <message>
        <source>the device is not ready yet</source>
        <translation>उपकरण अभी तैयार नहीं है</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>टिप्पणी: %1</translation>
    </message>
    <message>
        <source>new window at resolution %2</source>
        <translation>रिज़ॉल्यूशन %2 की नई विंडो</translation>
    </message>
    <message>
        <source>window at resolution %2</source>
        <translation>रिज़ॉल्यूशन %2 की विंडो</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Return</source>
        <translation>Return</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>millimetres</source>
        <translation>मिलीमीटर</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>सेंटीमीटर</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>मीटर</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>इंच</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>फ़ुट</translation>
    </message>
    <message>
        <source>US survey feet</source>
        <translation>अमेरिकी सर्वेक्षण फ़ुट</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>स्वचालित</translation>
    </message>
    <message>
        <source>Free view</source>
        <translation>मुक्त दृश्य</translation>
    </message>
    <message>
        <source>Best-fit plane</source>
        <translation>सर्वोत्तम समतल</translation>
    </message>
    <message>
        <source>Principal axes</source>
        <translation>मुख्य अक्ष</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>सामने</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>पीछे</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>बाएँ</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>दाएँ</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>ऊपर</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>नीचे</translation>
    </message>
    <message>
        <source>Automatic, as in earlier versions</source>
        <translation>स्वचालित, जैसे पुराने संस्करणों में</translation>
    </message>
    <message>
        <source>%1, turned to the left</source>
        <translation>%1, बाईं ओर घुमाया हुआ</translation>
    </message>
    <message>
        <source>%1, turned to the right</source>
        <translation>%1, दाईं ओर घुमाया हुआ</translation>
    </message>
    <message>
        <source>%1, upside down</source>
        <translation>%1, उल्टा</translation>
    </message>
</context>
<context>
    <name>relievo</name>
    <message>
        <source>There is not enough memory for this. Nothing was changed. Close other programs or choose a smaller file.</source>
        <translation>इसके लिए मेमोरी पर्याप्त नहीं है। कुछ नहीं बदला। दूसरे प्रोग्राम बंद करें या छोटी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>This failed unexpectedly: %1. Nothing was changed.</source>
        <translation>यह अप्रत्याशित रूप से विफल हुआ: %1। कुछ नहीं बदला।</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>%1 तक</translation>
    </message>
    <message>
        <source>longer than %1</source>
        <translation>%1 से लंबा</translation>
    </message>
    <message>
        <source>Not measured yet.</source>
        <translation>अभी मापा नहीं गया।</translation>
    </message>
    <message numerus="yes">
        <source>Force interrupted %n time(s).</source>
        <translation>
            <numerusform>बल %n बार रुका।</numerusform>
            <numerusform>बल %n बार रुका।</numerusform>
        </translation>
    </message>
    <message>
        <source>Softened against swinging, times: %1.</source>
        <translation>कंपन के विरुद्ध नरम किया, बार: %1।</translation>
    </message>
    <message>
        <source>Pauses after which the force rose anew: %1.</source>
        <translation>विराम जिनके बाद बल फिर बढ़ा: %1।</translation>
    </message>
    <message>
        <source>Slow.</source>
        <translation>धीमा।</translation>
    </message>
    <message>
        <source>Runs well.</source>
        <translation>ठीक चल रहा है।</translation>
    </message>
    <message>
        <source>%1 per second, %2 of %3 ticks late, longest gap %4 ms.</source>
        <translation>%1 प्रति सेकंड, %3 में से %2 चक्र देर से, सबसे लंबा अंतराल %4 ms।</translation>
    </message>
    <message>
        <source>Real-time priority granted.</source>
        <translation>रीयल-टाइम प्राथमिकता मिली।</translation>
    </message>
    <message>
        <source>No real-time priority; the tables say why.</source>
        <translation>रीयल-टाइम प्राथमिकता नहीं; कारण तालिकाओं में है।</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>उपकरण: %1</translation>
    </message>
    <message>
        <source>Computing, mean and longest: %1 µs, %2 µs</source>
        <translation>गणना समय, औसत और अधिकतम: %1 µs, %2 µs</translation>
    </message>
    <message>
        <source>Real time: everything was granted.</source>
        <translation>रीयल-टाइम: सब कुछ मिला।</translation>
    </message>
    <message>
        <source>Woken late by, in ticks:</source>
        <translation>जागने में देरी, चक्रों में:</translation>
    </message>
    <message>
        <source>Time spent computing, in ticks:</source>
        <translation>गणना में लगा समय, चक्रों में:</translation>
    </message>
    <message>
        <source>Waited for memory in %1 ticks.</source>
        <translation>%1 चक्रों में मेमोरी की प्रतीक्षा की।</translation>
    </message>
    <message>
        <source>Memory locked.</source>
        <translation>मेमोरी बाँधी गई।</translation>
    </message>
    <message>
        <source>Memory not locked; the tables say why.</source>
        <translation>मेमोरी नहीं बँधी; कारण तालिकाओं में है।</translation>
    </message>
    <message>
        <source>Page faults of the loop: %1, in %2 ticks</source>
        <translation>चक्र के पेज फ़ॉल्ट: %1, %2 चक्रों में</translation>
    </message>
    <message>
        <source>Memory locked: %1 kB</source>
        <translation>बँधी मेमोरी: %1 kB</translation>
    </message>
    <message>
        <source>&amp;Crop to a box</source>
        <translation>डिब्बे तक काटें (&amp;C)</translation>
    </message>
    <message>
        <source>Crop to an outline on the &amp;view</source>
        <translation>दृश्य पर रूपरेखा तक काटें (&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Stray points, as for most scans</source>
        <translation>भटके बिंदु, अधिकतर स्कैन के लिए (&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Outliers, statistical</source>
        <translation>सांख्यिकीय बाहरी बिंदु (&amp;O)</translation>
    </message>
    <message>
        <source>Outliers, within a &amp;radius</source>
        <translation>त्रिज्या के भीतर बाहरी बिंदु (&amp;R)</translation>
    </message>
    <message>
        <source>Thin &amp;beside dense</source>
        <translation>सघन के पास विरल (&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Equal points</source>
        <translation>समान बिंदु (&amp;E)</translation>
    </message>
    <message>
        <source>C&amp;lasses of points</source>
        <translation>बिंदुओं के वर्ग (&amp;L)</translation>
    </message>
    <message>
        <source>Returns of a p&amp;ulse</source>
        <translation>एक स्पंद की वापसियाँ (&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Intensities</source>
        <translation>तीव्रताएँ (&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Thin out</source>
        <translation>विरल करें (&amp;T)</translation>
    </message>
    <message>
        <source>Leave out the &amp;plane under the object</source>
        <translation>वस्तु के नीचे का तल छोड़ें (&amp;P)</translation>
    </message>
    <message>
        <source>Lay the plane under the object le&amp;vel</source>
        <translation>वस्तु के नीचे का तल समतल करें (&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Normals</source>
        <translation>अभिलंब (&amp;N)</translation>
    </message>
    <message>
        <source>what is outside stays</source>
        <translation>जो बाहर है वह रहता है</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 कोने</translation>
    </message>
    <message>
        <source>%1, what is outside stays</source>
        <translation>%1, जो बाहर है वह रहता है</translation>
    </message>
    <message>
        <source>all but noise</source>
        <translation>शोर को छोड़ सभी</translation>
    </message>
    <message>
        <source>first</source>
        <translation>पहली</translation>
    </message>
    <message>
        <source>last</source>
        <translation>अंतिम</translation>
    </message>
    <message>
        <source>single</source>
        <translation>एकमात्र</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 से %2</translation>
    </message>
    <message>
        <source>%1 neighbours, %2 deviations</source>
        <translation>%1 पड़ोसी, %2 विचलन</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 spacings</source>
        <translation>%1 अंतराल</translation>
    </message>
    <message>
        <source>fewer than %1 within %2</source>
        <translation>%2 के भीतर %1 से कम</translation>
    </message>
    <message>
        <source>%1 neighbours, %2 times</source>
        <translation>%1 पड़ोसी, %2 गुना</translation>
    </message>
    <message>
        <source>%1, off the surface %2 times</source>
        <translation>%1, सतह से %2 गुना दूर</translation>
    </message>
    <message>
        <source>one in %1 mm</source>
        <translation>%1 mm में एक</translation>
    </message>
    <message>
        <source>laid level</source>
        <translation>समतल रखा</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>छोड़ा गया</translation>
    </message>
    <message>
        <source>%1 neighbours</source>
        <translation>%1 पड़ोसी</translation>
    </message>
    <message>
        <source>as stored</source>
        <translation>जैसा सहेजा गया</translation>
    </message>
    <message>
        <source>by picked pairs</source>
        <translation>चुने हुए जोड़ों से</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>स्वचालित</translation>
    </message>
    <message>
        <source>Crop to a box</source>
        <translation>डिब्बे तक काटें</translation>
    </message>
    <message>
        <source>Crop to an outline</source>
        <translation>रूपरेखा तक काटें</translation>
    </message>
    <message>
        <source>Classes of points</source>
        <translation>बिंदुओं के वर्ग</translation>
    </message>
    <message>
        <source>Returns of a pulse</source>
        <translation>एक स्पंद की वापसियाँ</translation>
    </message>
    <message>
        <source>Intensities</source>
        <translation>तीव्रताएँ</translation>
    </message>
    <message>
        <source>Equal points</source>
        <translation>समान बिंदु</translation>
    </message>
    <message>
        <source>Outliers, statistical</source>
        <translation>सांख्यिकीय बाहरी बिंदु</translation>
    </message>
    <message>
        <source>Outliers, within a radius</source>
        <translation>त्रिज्या के भीतर बाहरी बिंदु</translation>
    </message>
    <message>
        <source>Thin beside dense</source>
        <translation>सघन के पास विरल</translation>
    </message>
    <message>
        <source>Thin out</source>
        <translation>विरल करें</translation>
    </message>
    <message>
        <source>Plane under the object</source>
        <translation>वस्तु के नीचे का तल</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>अभिलंब</translation>
    </message>
    <message>
        <source>Align and join</source>
        <translation>संरेखित करें और जोड़ें</translation>
    </message>
    <message>
        <source>What is being done</source>
        <translation>क्या हो रहा है</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>समस्या</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>प्रगति</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>रोकें (&amp;S)</translation>
    </message>
    <message>
        <source>Stop the work</source>
        <translation>काम रोकें</translation>
    </message>
    <message>
        <source>Map by tiles</source>
        <translation>टाइलों से मानचित्र</translation>
    </message>
    <message>
        <source>Looks at the hand 250 times a second while it rests; before:</source>
        <translation>हाथ के ठहरे रहते हुए उसे प्रति सेकंड 250 बार देखता है; पहले:</translation>
    </message>
</context>
<context>
    <name>relievo::AddressDialog</name>
    <message>
        <source>Open web address</source>
        <translation>वेब पता खोलें</translation>
    </message>
    <message>
        <source>&amp;Address of a published map</source>
        <translation>प्रकाशित मानचित्र का पता (&amp;A)</translation>
    </message>
    <message>
        <source>Address of a published map</source>
        <translation>प्रकाशित मानचित्र का पता</translation>
    </message>
    <message>
        <source>Of the folder that relievo publish made, or of its map.json</source>
        <translation>उस फ़ोल्डर का जो relievo publish ने बनाया, या उसकी map.json का</translation>
    </message>
    <message>
        <source>The server is asked when you open it.</source>
        <translation>खोलने पर सर्वर से पूछा जाता है।</translation>
    </message>
    <message>
        <source>An address begins with https://, http:// or s3://.</source>
        <translation>पता https://, http:// या s3:// से शुरू होता है।</translation>
    </message>
</context>
<context>
    <name>relievo::ButtonControl</name>
    <message>
        <source>Buttons</source>
        <translation>बटन</translation>
    </message>
    <message>
        <source>Gamepads rumble at contact and edge. It is a cue, no force.</source>
        <translation>गेमपैड छूने पर और किनारे पर कँपते हैं। यह संकेत है, बल नहीं।</translation>
    </message>
    <message>
        <source>Gamepads do not rumble.</source>
        <translation>गेमपैड नहीं कँपते।</translation>
    </message>
</context>
<context>
    <name>relievo::ButtonsPanel</name>
    <message>
        <source>Sca&amp;nning with one button</source>
        <translation>एक बटन से क्रमवार चुनाव (&amp;N)</translation>
    </message>
    <message>
        <source>Scanning with one button</source>
        <translation>एक बटन से क्रमवार चुनाव</translation>
    </message>
    <message>
        <source>Any button: the first press begins to offer where am I, finer, coarser, move, forces; the next one takes what was offered last.</source>
        <translation>कोई भी बटन: पहली बार दबाने पर मैं कहाँ हूँ, और बारीक, और मोटा, खिसकाना, बल एक-एक करके सुझाए जाते हैं; अगली बार दबाने पर आख़िरी सुझाव लिया जाता है।</translation>
    </message>
    <message>
        <source>How long each command is offered, in seconds</source>
        <translation>हर आदेश कितनी देर सुझाया जाए, सेकंड में</translation>
    </message>
    <message>
        <source>How long each command is offered.</source>
        <translation>हर आदेश कितनी देर सुझाया जाए।</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>What a SpaceMouse moves</source>
        <translation>SpaceMouse क्या चलाए</translation>
    </message>
    <message>
        <source>The hand</source>
        <translation>हाथ</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>दृश्य</translation>
    </message>
    <message>
        <source>Each offer</source>
        <translation>हर प्रस्ताव</translation>
    </message>
    <message>
        <source>SpaceMouse moves</source>
        <translation>SpaceMouse चलाए</translation>
    </message>
    <message>
        <source>Gamepads r&amp;umble (a cue)</source>
        <translation>गेमपैड कँपें (एक संकेत) (&amp;U)</translation>
    </message>
    <message>
        <source>Gamepads rumble at contact and edge</source>
        <translation>छूने पर और किनारे पर गेमपैड कँपें</translation>
    </message>
    <message>
        <source>A knock when the hand meets the surface, and a soft hum at the edge of the window. It is a cue: it has no direction and is no force.</source>
        <translation>हाथ के सतह से मिलने पर एक ठोकर, और विंडो के किनारे पर हल्की गूँज। यह एक संकेत है: इसकी कोई दिशा नहीं और यह बल नहीं है।</translation>
    </message>
    <message>
        <source>What the cap of a 3Dconnexion SpaceMouse moves. The hand follows pushes only. In the view the relief follows the cap: pushed to a side, up or down it moves, toward you it comes nearer; tilted forward or back, or twisted, it turns.</source>
        <translation>3Dconnexion SpaceMouse की टोपी क्या चलाए। हाथ केवल धकेलने के साथ चलता है। दृश्य में उभार टोपी के साथ चलता है: किनारे, ऊपर या नीचे धकेलने पर खिसकता है, आपकी ओर खींचने पर पास आता है; आगे-पीछे झुकाने या मरोड़ने पर घूमता है।</translation>
    </message>
</context>
<context>
    <name>relievo::CellLegend</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>less than %1 %</source>
        <translation>%1 % से कम</translation>
    </message>
    <message>
        <source>interpolated: %1</source>
        <translation>अंतर्वेशित: %1</translation>
    </message>
    <message>
        <source>hole, on base plane: %1</source>
        <translation>छेद, आधार तल पर: %1</translation>
    </message>
    <message>
        <source>All cells in view were measured</source>
        <translation>दिखने वाली सभी कोशिकाएँ मापी गई हैं</translation>
    </message>
    <message>
        <source>Legend of marks</source>
        <translation>चिह्नों की कुंजी</translation>
    </message>
    <message>
        <source>ball: proxy, on the surface</source>
        <translation>गोला: प्रॉक्सी, सतह पर</translation>
    </message>
    <message>
        <source>ring with a cross: HIP</source>
        <translation>क्रॉस वाला छल्ला: HIP</translation>
    </message>
</context>
<context>
    <name>relievo::CloudView</name>
    <message>
        <source>A point under the cross: %1, %2, %3</source>
        <translation>क्रॉस के नीचे एक बिंदु: %1, %2, %3</translation>
    </message>
    <message>
        <source>No point under the cross</source>
        <translation>क्रॉस के नीचे कोई बिंदु नहीं</translation>
    </message>
    <message numerus="yes">
        <source>%n corner(s) so far</source>
        <translation>
            <numerusform>अब तक %n कोना</numerusform>
            <numerusform>अब तक %n कोने</numerusform>
        </translation>
    </message>
    <message>
        <source>An outline needs three corners</source>
        <translation>रूपरेखा को तीन कोने चाहिए</translation>
    </message>
</context>
<context>
    <name>relievo::ColourBar</name>
    <message>
        <source>Bar of colours</source>
        <translation>रंग पट्टी</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1, %2 से %3 तक</translation>
    </message>
</context>
<context>
    <name>relievo::CommandSearch</name>
    <message>
        <source>Search commands</source>
        <translation>आदेश खोजें</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>आदेश के शब्द</translation>
    </message>
    <message>
        <source>Words of a command&apos;s name or explanation; Enter runs the first</source>
        <translation>आदेश के नाम या व्याख्या के शब्द; Enter पहला चलाता है</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>आप क्या करना चाहते हैं?</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>आदेश</translation>
    </message>
    <message>
        <source>No command has these words. Try one word, or another for the same; F1 lists all keys, Shift+F1 opens the manual.</source>
        <translation>किसी आदेश में ये शब्द नहीं। एक ही शब्द, या उसी का दूसरा शब्द आज़माएँ; F1 सब कुंजियाँ दिखाता है, Shift+F1 पुस्तिका खोलता है।</translation>
    </message>
</context>
<context>
    <name>relievo::CommandTable</name>
    <message>
        <source>&amp;File</source>
        <translation>फ़ाइल (&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>संपादन (&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>दृश्य (&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Detail view</source>
        <translation>विवरण दृश्य (&amp;D)</translation>
    </message>
    <message>
        <source>What the left button does, and turning by keys</source>
        <translation>बायाँ बटन क्या करता है, और कुंजियों से घुमाना</translation>
    </message>
    <message>
        <source>Relief ima&amp;ge</source>
        <translation>उभार का चित्र (&amp;G)</translation>
    </message>
    <message>
        <source>How heights are painted</source>
        <translation>ऊँचाइयाँ कैसे रंगी जाती हैं</translation>
    </message>
    <message>
        <source>R&amp;elief colours</source>
        <translation>उभार के रंग (&amp;E)</translation>
    </message>
    <message>
        <source>Colours of heights, slopes and other values</source>
        <translation>ऊँचाइयों, ढालों और दूसरे मानों के रंग</translation>
    </message>
    <message>
        <source>Ke&amp;y light</source>
        <translation>मुख्य प्रकाश (&amp;Y)</translation>
    </message>
    <message>
        <source>From where the light shines; low light brings out detail</source>
        <translation>प्रकाश कहाँ से आता है; नीचा प्रकाश बारीकियाँ उभारता है</translation>
    </message>
    <message>
        <source>Lig&amp;ht or dark</source>
        <translation>हल्का या गहरा (&amp;H)</translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation>खिड़की के रंग</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>सतह (&amp;S)</translation>
    </message>
    <message>
        <source>How the depth map is made</source>
        <translation>गहराई मानचित्र कैसे बनता है</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>माप (&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Touch</source>
        <translation>स्पर्श (&amp;T)</translation>
    </message>
    <message>
        <source>Re&amp;cord</source>
        <translation>रिकॉर्ड (&amp;C)</translation>
    </message>
    <message>
        <source>Record &amp;as</source>
        <translation>रिकॉर्डिंग का रूप (&amp;A)</translation>
    </message>
    <message>
        <source>Kind of file of the next recording</source>
        <translation>अगली रिकॉर्डिंग की फ़ाइल का प्रकार</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>सहायता (&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>खोलें (&amp;O)…</translation>
    </message>
    <message>
        <source>Open a scan or a height map</source>
        <translation>स्कैन या ऊँचाई मानचित्र खोलें</translation>
    </message>
    <message>
        <source>Open fol&amp;der…</source>
        <translation>फ़ोल्डर खोलें (&amp;D)…</translation>
    </message>
    <message>
        <source>Open all scans of a folder: parts of one object</source>
        <translation>फ़ोल्डर के सभी स्कैन खोलें: एक वस्तु के भाग</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>परियोजना सहेजें (&amp;S)</translation>
    </message>
    <message>
        <source>Keep this state: file, depth map, window, measurements</source>
        <translation>यह स्थिति रखें: फ़ाइल, गहराई मानचित्र, विंडो, माप</translation>
    </message>
    <message>
        <source>Save project &amp;as…</source>
        <translation>परियोजना इस रूप में सहेजें (&amp;A)…</translation>
    </message>
    <message>
        <source>Keep this state in another file</source>
        <translation>यह स्थिति दूसरी फ़ाइल में रखें</translation>
    </message>
    <message>
        <source>&amp;Figure…</source>
        <translation>चित्र (&amp;F)…</translation>
    </message>
    <message>
        <source>A figure for print, with scale bar, legend and caption</source>
        <translation>छपाई के लिए चित्र, पैमाना पट्टी, संकेत सूची और शीर्षक के साथ</translation>
    </message>
    <message>
        <source>&amp;Image…</source>
        <translation>तस्वीर (&amp;I)…</translation>
    </message>
    <message>
        <source>Save a picture of a view or of the window</source>
        <translation>किसी दृश्य या खिड़की की तस्वीर सहेजें</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>निर्यात (&amp;X)…</translation>
    </message>
    <message>
        <source>A map, mesh, picture, profile or section for other programs</source>
        <translation>दूसरे कार्यक्रमों के लिए मानचित्र, जाल, चित्र, प्रोफ़ाइल या काट</translation>
    </message>
    <message>
        <source>One zip with project, scan, recordings, figures and checksums</source>
        <translation>परियोजना, स्कैन, रिकॉर्डिंग, चित्र और जाँच-योग की एक zip फ़ाइल</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>बंद करें (&amp;C)</translation>
    </message>
    <message>
        <source>Close the scan and go back to the start page</source>
        <translation>स्कैन बंद करें और आरंभ पृष्ठ पर लौटें</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>बाहर निकलें (&amp;Q)</translation>
    </message>
    <message>
        <source>Close relievo</source>
        <translation>relievo बंद करें</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>पूर्ववत (&amp;U)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>पूर्ववत</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>फिर करें (&amp;R)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>फिर करें</translation>
    </message>
    <message>
        <source>&amp;History…</source>
        <translation>इतिहास (&amp;H)…</translation>
    </message>
    <message>
        <source>Every step so far; choose one to go back to it</source>
        <translation>अब तक का हर चरण; लौटने के लिए एक चुनें</translation>
    </message>
    <message>
        <source>&amp;Copy view as text</source>
        <translation>दृश्य को पाठ के रूप में कॉपी करें (&amp;C)</translation>
    </message>
    <message>
        <source>Paste &amp;view</source>
        <translation>दृश्य चिपकाएँ (&amp;V)</translation>
    </message>
    <message>
        <source>Show the view that was copied as text</source>
        <translation>पाठ के रूप में कॉपी किया गया दृश्य दिखाएँ</translation>
    </message>
    <message>
        <source>&amp;Answer the message</source>
        <translation>संदेश का उत्तर दें (&amp;A)</translation>
    </message>
    <message>
        <source>Press the first button of the message above the views</source>
        <translation>दृश्यों के ऊपर के संदेश का पहला बटन दबाएँ</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>वरीयताएँ (&amp;P)…</translation>
    </message>
    <message>
        <source>Colours, text size, language, units, stereo, device</source>
        <translation>रंग, पाठ का आकार, भाषा, इकाइयाँ, स्टीरियो, उपकरण</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>सामने (&amp;F)</translation>
    </message>
    <message>
        <source>Look from this side and make the relief anew</source>
        <translation>इस ओर से देखें और उभार फिर बनाएँ</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>पीछे (&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>बाएँ (&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>दाएँ (&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>ऊपर (&amp;T)</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>नीचे (&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>स्वचालित (&amp;A)</translation>
    </message>
    <message>
        <source>Look from the side that shows most</source>
        <translation>उस ओर से देखें जहाँ से सबसे अधिक दिखे</translation>
    </message>
    <message>
        <source>Loo&amp;k with the left button</source>
        <translation>बाएँ बटन से देखें (&amp;K)</translation>
    </message>
    <message>
        <source>Dragging with the left button turns the detail view</source>
        <translation>बाएँ बटन से खींचना विवरण दृश्य को घुमाता है</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>देखना</translation>
    </message>
    <message>
        <source>&amp;Touch with the left button</source>
        <translation>बाएँ बटन से स्पर्श करें (&amp;T)</translation>
    </message>
    <message>
        <source>The left button presses the hand into the surface</source>
        <translation>बायाँ बटन हाथ को सतह में दबाता है</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>स्पर्श</translation>
    </message>
    <message>
        <source>&amp;Switch between look and touch</source>
        <translation>देखने और स्पर्श के बीच बदलें (&amp;S)</translation>
    </message>
    <message>
        <source>What the left button does in the detail view: turn it, or press the hand in</source>
        <translation>बायाँ बटन विवरण दृश्य में क्या करता है: उसे घुमाना, या हाथ भीतर दबाना</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>बाएँ घुमाएँ (&amp;L)</translation>
    </message>
    <message>
        <source>Turn the detail view by 15 degrees</source>
        <translation>विवरण दृश्य को 15 डिग्री घुमाएँ</translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation>दाएँ घुमाएँ (&amp;R)</translation>
    </message>
    <message>
        <source>Turn &amp;up</source>
        <translation>ऊपर घुमाएँ (&amp;U)</translation>
    </message>
    <message>
        <source>Turn &amp;down</source>
        <translation>नीचे घुमाएँ (&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Use this view</source>
        <translation>यह दृश्य लें (&amp;U)</translation>
    </message>
    <message>
        <source>Make the relief anew from where the turned detail view looks</source>
        <translation>घुमाए गए विवरण दृश्य की दिशा से उभार फिर बनाएँ</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>समाएँ (&amp;I)</translation>
    </message>
    <message>
        <source>Look straight down on the relief, fitted to the view</source>
        <translation>उभार को सीधे ऊपर से देखें, दृश्य में समाया हुआ</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>स्टीरियो</translation>
    </message>
    <message>
        <source>Show or hide the whole object</source>
        <translation>पूरी वस्तु दिखाएँ या छिपाएँ</translation>
    </message>
    <message>
        <source>Show or hide the side panels</source>
        <translation>पार्श्व पटल दिखाएँ या छिपाएँ</translation>
    </message>
    <message>
        <source>Pl&amp;ots</source>
        <translation>आलेख (&amp;O)</translation>
    </message>
    <message>
        <source>Show or hide the plots of height and force</source>
        <translation>ऊँचाई और बल के आलेख दिखाएँ या छिपाएँ</translation>
    </message>
    <message>
        <source>Matt stone under lamps</source>
        <translation>दीपों के नीचे फीका पत्थर</translation>
    </message>
    <message>
        <source>&amp;Height in colour</source>
        <translation>रंग में ऊँचाई (&amp;H)</translation>
    </message>
    <message>
        <source>H&amp;illshade</source>
        <translation>पहाड़ी छाया (&amp;I)</translation>
    </message>
    <message>
        <source>Brightness under one light</source>
        <translation>एक प्रकाश में उजाला</translation>
    </message>
    <message>
        <source>Hillshade, &amp;four lights</source>
        <translation>पहाड़ी छाया, चार प्रकाश (&amp;F)</translation>
    </message>
    <message>
        <source>No direction stays in the dark</source>
        <translation>कोई दिशा अँधेरे में नहीं रहती</translation>
    </message>
    <message>
        <source>&amp;Slope</source>
        <translation>ढाल (&amp;S)</translation>
    </message>
    <message>
        <source>Steepness in degrees</source>
        <translation>ढाल का कोण, डिग्री में</translation>
    </message>
    <message>
        <source>Local &amp;relief</source>
        <translation>स्थानीय उभार (&amp;R)</translation>
    </message>
    <message>
        <source>Worn detail without the broad shape</source>
        <translation>बड़े आकार के बिना घिसे विवरण</translation>
    </message>
    <message>
        <source>Sky &amp;view</source>
        <translation>आकाश-दृश्य (&amp;V)</translation>
    </message>
    <message>
        <source>How much of the sky each place sees</source>
        <translation>हर जगह से आकाश कितना दिखता है</translation>
    </message>
    <message>
        <source>&amp;Openness</source>
        <translation>खुलापन (&amp;O)</translation>
    </message>
    <message>
        <source>Hollows dark, ridges bright</source>
        <translation>गड्ढे गहरे, धारियाँ उजली</translation>
    </message>
    <message>
        <source>&amp;Deviation, several scales</source>
        <translation>विचलन, कई पैमाने (&amp;D)</translation>
    </message>
    <message>
        <source>What stands out from its neighbourhood, at the scale where it does so most</source>
        <translation>जो अपने पड़ोस से उभरता है, उस पैमाने पर जहाँ वह सबसे अधिक उभरता है</translation>
    </message>
    <message>
        <source>&amp;Curvature, several scales</source>
        <translation>वक्रता, कई पैमाने (&amp;C)</translation>
    </message>
    <message>
        <source>Ridges and incisions of several widths, however the ground is tilted</source>
        <translation>अलग-अलग चौड़ाई की धारियाँ और खाँचे, ज़मीन चाहे जैसे झुकी हो</translation>
    </message>
    <message>
        <source>&amp;Natural colours</source>
        <translation>प्राकृतिक रंग (&amp;N)</translation>
    </message>
    <message>
        <source>The colours that the scan has</source>
        <translation>वे रंग जो स्कैन में हैं</translation>
    </message>
    <message>
        <source>In&amp;tensity</source>
        <translation>तीव्रता (&amp;T)</translation>
    </message>
    <message>
        <source>How strongly the scanner&apos;s light came back</source>
        <translation>स्कैनर का प्रकाश कितना तेज़ लौटा</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>धूसर (&amp;G)</translation>
    </message>
    <message>
        <source>Colours that grow lighter in even steps</source>
        <translation>रंग जो समान चरणों में उजले होते हैं</translation>
    </message>
    <message>
        <source>&amp;Viridis</source>
        <translation>Viridis (&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Cividis</source>
        <translation>Cividis (&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Batlow</source>
        <translation>Batlow (&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Usual light</source>
        <translation>सामान्य प्रकाश (&amp;U)</translation>
    </message>
    <message>
        <source>From the upper left, 45 degrees high</source>
        <translation>ऊपर बाएँ से, 45 अंश ऊँचा</translation>
    </message>
    <message>
        <source>Raking from the &amp;left</source>
        <translation>बाएँ से तिरछा प्रकाश (&amp;L)</translation>
    </message>
    <message>
        <source>Light almost along the surface, 10 degrees above it</source>
        <translation>लगभग सतह के साथ-साथ प्रकाश, उससे 10 अंश ऊपर</translation>
    </message>
    <message>
        <source>Raking from the &amp;right</source>
        <translation>दाएँ से तिरछा प्रकाश (&amp;R)</translation>
    </message>
    <message>
        <source>Raking from &amp;above</source>
        <translation>ऊपर से तिरछा प्रकाश (&amp;A)</translation>
    </message>
    <message>
        <source>Raking from &amp;below</source>
        <translation>नीचे से तिरछा प्रकाश (&amp;B)</translation>
    </message>
    <message>
        <source>Turn &amp;counterclockwise</source>
        <translation>घड़ी की उलटी दिशा में घुमाएँ (&amp;C)</translation>
    </message>
    <message>
        <source>Turn the light by 5 degrees, counterclockwise</source>
        <translation>प्रकाश को 5 अंश घड़ी की उलटी दिशा में घुमाएँ</translation>
    </message>
    <message>
        <source>Turn cloc&amp;kwise</source>
        <translation>घड़ी की दिशा में घुमाएँ (&amp;K)</translation>
    </message>
    <message>
        <source>Turn the light by 5 degrees, clockwise</source>
        <translation>प्रकाश को 5 अंश घड़ी की दिशा में घुमाएँ</translation>
    </message>
    <message>
        <source>&amp;Higher</source>
        <translation>ऊँचा (&amp;H)</translation>
    </message>
    <message>
        <source>The light 5 degrees higher</source>
        <translation>प्रकाश 5 अंश ऊँचा</translation>
    </message>
    <message>
        <source>Lo&amp;wer</source>
        <translation>नीचा (&amp;W)</translation>
    </message>
    <message>
        <source>The light 5 degrees lower: worn detail comes out</source>
        <translation>प्रकाश 5 अंश नीचा: घिसी बारीकियाँ उभरती हैं</translation>
    </message>
    <message>
        <source>Mar&amp;k unmeasured cells</source>
        <translation>बिना मापी कोशिकाएँ दिखाएँ (&amp;K)</translation>
    </message>
    <message>
        <source>Cells that were interpolated in colour, with a legend; holes are always hatched</source>
        <translation>अंतर्वेशित कोशिकाएँ रंग में, कुंजी के साथ; छेद हमेशा रेखांकित रहते हैं</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>प्रणाली जैसा (&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>हल्का (&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>गहरा (&amp;D)</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>उच्च कंट्रास्ट (&amp;H)</translation>
    </message>
    <message>
        <source>Full s&amp;creen detail</source>
        <translation>पूर्ण स्क्रीन विवरण (&amp;C)</translation>
    </message>
    <message>
        <source>The detail view alone on the whole screen</source>
        <translation>केवल विवरण दृश्य पूरी स्क्रीन पर</translation>
    </message>
    <message>
        <source>Other vie&amp;w</source>
        <translation>दूसरा दृश्य (&amp;W)</translation>
    </message>
    <message>
        <source>Ne&amp;xt part</source>
        <translation>अगला भाग (&amp;X)</translation>
    </message>
    <message>
        <source>Move the focus to the next part of the window</source>
        <translation>फ़ोकस खिड़की के अगले भाग पर ले जाएँ</translation>
    </message>
    <message>
        <source>Move the focus to the part before</source>
        <translation>फ़ोकस पिछले भाग पर ले जाएँ</translation>
    </message>
    <message>
        <source>&amp;Finer</source>
        <translation>बारीक (&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Coarser</source>
        <translation>मोटा (&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Whole object</source>
        <translation>पूरी वस्तु (&amp;W)</translation>
    </message>
    <message>
        <source>The whole object in the window</source>
        <translation>पूरी वस्तु विंडो में</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>पूरा</translation>
    </message>
    <message>
        <source>Move &amp;left</source>
        <translation>बाएँ खिसकाएँ (&amp;L)</translation>
    </message>
    <message>
        <source>Move the window by a quarter of its side</source>
        <translation>विंडो को उसकी भुजा के चौथाई से खिसकाएँ</translation>
    </message>
    <message>
        <source>Move &amp;right</source>
        <translation>दाएँ खिसकाएँ (&amp;R)</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>ऊपर खिसकाएँ (&amp;U)</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>नीचे खिसकाएँ (&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Type window…</source>
        <translation>विंडो टाइप करें (&amp;T)…</translation>
    </message>
    <message>
        <source>Type the window&apos;s place and size in millimetres</source>
        <translation>विंडो की जगह और आकार मिलीमीटर में टाइप करें</translation>
    </message>
    <message>
        <source>&amp;Suggest windows</source>
        <translation>विंडो सुझाएँ (&amp;S)</translation>
    </message>
    <message>
        <source>Rank windows by how much of their relief a hand feels</source>
        <translation>विंडो को इससे क्रम दें कि उनके उभार का कितना भाग हाथ महसूस करता है</translation>
    </message>
    <message>
        <source>Prep&amp;are…</source>
        <translation>तैयार करें (&amp;A)…</translation>
    </message>
    <message>
        <source>Crop, clean, thin and join scans before the depth map</source>
        <translation>गहराई मानचित्र से पहले स्कैन काटें, साफ़ करें, विरल करें और जोड़ें</translation>
    </message>
    <message>
        <source>Depth ma&amp;p…</source>
        <translation>गहराई मानचित्र (&amp;P)…</translation>
    </message>
    <message>
        <source>Everything between the scan and its depth map, with a preview</source>
        <translation>स्कैन और उसके गहराई मानचित्र के बीच सब कुछ, पूर्वावलोकन के साथ</translation>
    </message>
    <message>
        <source>U&amp;nits…</source>
        <translation>इकाइयाँ (&amp;N)…</translation>
    </message>
    <message>
        <source>Say which length unit the file&apos;s coordinates have; kept for its folder</source>
        <translation>बताएँ कि फ़ाइल के निर्देशांक किस इकाई में हैं; उसके फ़ोल्डर के लिए याद रहता है</translation>
    </message>
    <message>
        <source>Make the depth map on the processor</source>
        <translation>गहराई मानचित्र प्रोसेसर से बनाएँ</translation>
    </message>
    <message>
        <source>Make the depth map by the graphics card&apos;s depth buffer</source>
        <translation>गहराई मानचित्र ग्राफ़िक्स कार्ड के गहराई बफ़र से बनाएँ</translation>
    </message>
    <message>
        <source>&amp;Point</source>
        <translation>बिंदु (&amp;P)</translation>
    </message>
    <message>
        <source>Height of one place</source>
        <translation>एक जगह की ऊँचाई</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>दूरी (&amp;D)</translation>
    </message>
    <message>
        <source>Between two places</source>
        <translation>दो जगहों के बीच</translation>
    </message>
    <message>
        <source>Depth di&amp;fference</source>
        <translation>गहराई का अंतर (&amp;F)</translation>
    </message>
    <message>
        <source>How much higher the second place lies</source>
        <translation>दूसरी जगह कितनी ऊँची है</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>कोण (&amp;A)</translation>
    </message>
    <message>
        <source>At the second of three places</source>
        <translation>तीन में से दूसरी जगह पर</translation>
    </message>
    <message>
        <source>P&amp;rofile</source>
        <translation>प्रोफ़ाइल (&amp;R)</translation>
    </message>
    <message>
        <source>Heights along a line</source>
        <translation>रेखा के साथ ऊँचाइयाँ</translation>
    </message>
    <message>
        <source>Area and &amp;volume</source>
        <translation>क्षेत्रफल और आयतन (&amp;V)</translation>
    </message>
    <message>
        <source>Of a piece of surface above its lowest corner, or another plane</source>
        <translation>सतह के एक भाग का, उसके सबसे नीचे के कोने या किसी दूसरे समतल के ऊपर</translation>
    </message>
    <message>
        <source>Se&amp;ction</source>
        <translation>काट (&amp;C)</translation>
    </message>
    <message>
        <source>Where a plane through one, two or three places cuts the surface</source>
        <translation>जहाँ एक, दो या तीन जगहों से होकर जाता समतल सतह को काटता है</translation>
    </message>
    <message>
        <source>By &amp;touch</source>
        <translation>स्पर्श से (&amp;T)</translation>
    </message>
    <message>
        <source>Taps of the hand that feels the surface give depth differences, strokes profiles</source>
        <translation>सतह को महसूस करते हाथ की टैप से गहराई का अंतर मिलता है, खींची रेखा से प्रोफ़ाइल</translation>
    </message>
    <message>
        <source>Profile c&amp;urve</source>
        <translation>प्रोफ़ाइल वक्र (&amp;U)</translation>
    </message>
    <message>
        <source>Show or hide the curve of the selected profile under the views</source>
        <translation>चुनी प्रोफ़ाइल का वक्र दृश्यों के नीचे दिखाएँ या छिपाएँ</translation>
    </message>
    <message>
        <source>Save profil&amp;e as shown…</source>
        <translation>प्रोफ़ाइल जैसी दिखती है सहेजें… (&amp;E)</translation>
    </message>
    <message>
        <source>The curve under the views with its cursor as SVG, or its numbers as CSV</source>
        <translation>दृश्यों के नीचे का वक्र अपने सूचक के साथ SVG में, या उसकी संख्याएँ CSV में</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>सहेजें (&amp;S)…</translation>
    </message>
    <message>
        <source>The list as CSV, or the selected profile or section as CSV or SVG</source>
        <translation>सूची CSV में, या चुना प्रोफ़ाइल या काट CSV या SVG में</translation>
    </message>
    <message>
        <source>&amp;CSV</source>
        <translation>&amp;CSV</translation>
    </message>
    <message>
        <source>A table as text that every program opens</source>
        <translation>पाठ की तालिका जिसे हर प्रोग्राम खोलता है</translation>
    </message>
    <message>
        <source>&amp;HDF5</source>
        <translation>&amp;HDF5</translation>
    </message>
    <message>
        <source>Smaller, with units and surface; for Python and MATLAB</source>
        <translation>छोटी, इकाइयों और सतह के साथ; Python और MATLAB के लिए</translation>
    </message>
    <message>
        <source>F&amp;older of recordings…</source>
        <translation>रिकॉर्डिंग का फ़ोल्डर… (&amp;O)</translation>
    </message>
    <message>
        <source>Where recordings go that are made from now on</source>
        <translation>अब से बनने वाली रिकॉर्डिंग कहाँ जाएँगी</translation>
    </message>
    <message>
        <source>Re&amp;play…</source>
        <translation>पुनः दिखाएँ (&amp;P)…</translation>
    </message>
    <message>
        <source>Show a recording of a touch again; no device is moved</source>
        <translation>स्पर्श की रिकॉर्डिंग फिर दिखाएँ; कोई उपकरण नहीं हिलता</translation>
    </message>
    <message>
        <source>P&amp;lay or pause</source>
        <translation>चलाएँ या रोकें (&amp;L)</translation>
    </message>
    <message>
        <source>Go on with the replay, or halt it</source>
        <translation>पुनर्प्रदर्शन जारी रखें या रोकें</translation>
    </message>
    <message>
        <source>Ne&amp;xt event</source>
        <translation>अगली घटना (&amp;X)</translation>
    </message>
    <message>
        <source>Go to the next event or note of the recording</source>
        <translation>रिकॉर्डिंग की अगली घटना या टिप्पणी पर जाएँ</translation>
    </message>
    <message>
        <source>Event &amp;before</source>
        <translation>पिछली घटना (&amp;B)</translation>
    </message>
    <message>
        <source>Go back to the event or note before</source>
        <translation>पिछली घटना या टिप्पणी पर लौटें</translation>
    </message>
    <message>
        <source>&amp;Close replay</source>
        <translation>पुनर्प्रदर्शन बंद करें (&amp;C)</translation>
    </message>
    <message>
        <source>Back to the window from before</source>
        <translation>पहले वाली विंडो पर वापस</translation>
    </message>
    <message>
        <source>A video of the replay, or of the camera path, frame by frame</source>
        <translation>पुनर्प्रदर्शन या कैमरा पथ का वीडियो, फ़्रेम दर फ़्रेम</translation>
    </message>
    <message>
        <source>Video of the vie&amp;w</source>
        <translation>दृश्य का वीडियो (&amp;W)</translation>
    </message>
    <message>
        <source>Start or stop a video of what the detail view and the plots show</source>
        <translation>विवरण दृश्य और आलेख जो दिखाते हैं उसका वीडियो शुरू या बंद करें</translation>
    </message>
    <message>
        <source>Add &amp;key view</source>
        <translation>मुख्य दृश्य जोड़ें (&amp;K)</translation>
    </message>
    <message>
        <source>Let the camera path pass this view, three seconds after the one before</source>
        <translation>कैमरा पथ इस दृश्य से गुज़रे, पिछले के तीन सेकंड बाद</translation>
    </message>
    <message>
        <source>Show camera pa&amp;th</source>
        <translation>कैमरा पथ दिखाएँ (&amp;T)</translation>
    </message>
    <message>
        <source>Run along the key views once, or stop</source>
        <translation>मुख्य दृश्यों से एक बार गुज़रें, या रोकें</translation>
    </message>
    <message>
        <source>&amp;Forget key views</source>
        <translation>मुख्य दृश्य भूलें (&amp;F)</translation>
    </message>
    <message>
        <source>Begin a new camera path</source>
        <translation>नया कैमरा पथ शुरू करें</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>पुस्तिका (&amp;M)</translation>
    </message>
    <message>
        <source>Help in the browser, at the page for what has the keyboard; guide, documentation</source>
        <translation>ब्राउज़र में पुस्तिका, उस भाग के पृष्ठ पर जहाँ कुंजीपटल है; सहायता, मार्गदर्शिका, दस्तावेज़</translation>
    </message>
    <message>
        <source>&amp;Search commands…</source>
        <translation>आदेश खोजें (&amp;S)…</translation>
    </message>
    <message>
        <source>Find a command by its words and run it</source>
        <translation>शब्दों से आदेश खोजें और चलाएँ</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>कुंजियाँ (&amp;K)</translation>
    </message>
    <message>
        <source>All keys on one sheet</source>
        <translation>सब कुंजियाँ एक पन्ने पर</translation>
    </message>
    <message>
        <source>&amp;Introduction</source>
        <translation>परिचय (&amp;I)</translation>
    </message>
    <message>
        <source>Say what is open and how it is touched</source>
        <translation>बताएँ कि क्या खुला है और उसे कैसे छुएँ</translation>
    </message>
    <message>
        <source>&amp;About relievo</source>
        <translation>relievo के बारे में (&amp;A)</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>संस्करण और लाइसेंस</translation>
    </message>
    <message>
        <source>Depth m&amp;ethod</source>
        <translation>गहराई विधि (&amp;E)</translation>
    </message>
    <message>
        <source>Export archive pac&amp;kage…</source>
        <translation>संग्रह पैकेज निर्यात… (&amp;K)</translation>
    </message>
    <message>
        <source>Over&amp;view</source>
        <translation>अवलोकन (&amp;V)</translation>
    </message>
    <message>
        <source>Side pa&amp;nels</source>
        <translation>पार्श्व पटल (&amp;N)</translation>
    </message>
    <message>
        <source>Shaded re&amp;lief</source>
        <translation>छायांकित उभार (&amp;L)</translation>
    </message>
    <message>
        <source>Move the focus between the overview and the detail view</source>
        <translation>फ़ोकस को अवलोकन और विवरण दृश्य के बीच बदलें</translation>
    </message>
    <message>
        <source>&amp;Previous part</source>
        <translation>पिछला भाग (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;CPU</source>
        <translation>&amp;CPU</translation>
    </message>
    <message>
        <source>&amp;OpenGL</source>
        <translation>&amp;OpenGL</translation>
    </message>
    <message>
        <source>Save &amp;video…</source>
        <translation>वीडियो सहेजें… (&amp;V)</translation>
    </message>
    <message>
        <source>Keep view and &amp;zoom for next file</source>
        <translation>अगली फ़ाइल के लिए दृश्य और ज़ूम रखें (&amp;Z)</translation>
    </message>
    <message>
        <source>The next file is seen from the same side, turned and placed alike; Ctrl while dropping it does the same once</source>
        <translation>अगली फ़ाइल उसी ओर से, उतनी ही घुमाई हुई और उसी जगह पर दिखेगी; छोड़ते समय Ctrl यही एक बार करता है</translation>
    </message>
    <message>
        <source>&amp;Stereo</source>
        <translation>स्टीरियो (&amp;S)</translation>
    </message>
    <message>
        <source>Depth for two eyes: red and cyan glasses, or a screen for stereo</source>
        <translation>दो आँखों के लिए गहराई: लाल-सियान चश्मा, या स्टीरियो पर्दा</translation>
    </message>
    <message>
        <source>Mar&amp;ker here</source>
        <translation>यहाँ चिह्न (&amp;K)</translation>
    </message>
    <message>
        <source>Mark the place under the hand, or remove the marker there</source>
        <translation>हाथ के नीचे की जगह पर चिह्न लगाएँ, या वहाँ का चिह्न हटाएँ</translation>
    </message>
    <message>
        <source>Begin s&amp;itting of a study…</source>
        <translation>अध्ययन का सत्र शुरू करें… (&amp;I)</translation>
    </message>
    <message>
        <source>Next con&amp;dition</source>
        <translation>अगली शर्त (&amp;D)</translation>
    </message>
    <message>
        <source>Show the next condition of the sitting, or end it after the last</source>
        <translation>सत्र की अगली शर्त दिखाएँ, या अंतिम के बाद सत्र समाप्त करें</translation>
    </message>
    <message>
        <source>End sittin&amp;g</source>
        <translation>सत्र समाप्त करें (&amp;G)</translation>
    </message>
    <message>
        <source>End the sitting before all conditions were shown</source>
        <translation>सभी शर्तें दिखाने से पहले सत्र समाप्त करें</translation>
    </message>
    <message>
        <source>Show the points or the mesh behind the relief in the place of the overview, turned freely</source>
        <translation>अवलोकन की जगह उभार के पीछे के बिंदु या जाल दिखाएँ, स्वतंत्र रूप से घुमाए हुए</translation>
    </message>
    <message>
        <source>3-D</source>
        <translation>3-D</translation>
    </message>
    <message>
        <source>Make the relief anew from where the scan in 3-D is looked at</source>
        <translation>जहाँ से 3-D में स्कैन देखा जा रहा है वहाँ से उभार फिर बनाएँ</translation>
    </message>
    <message>
        <source>Scan in &amp;3-D</source>
        <translation>स्कैन 3-D में (&amp;3)</translation>
    </message>
    <message>
        <source>Make rel&amp;ief as the scan is seen</source>
        <translation>जैसा स्कैन दिखता है वैसा उभार बनाएँ (&amp;I)</translation>
    </message>
    <message>
        <source>Region, level, vertical exaggeration, light, colours and turn, to be sent or pasted</source>
        <translation>क्षेत्र, स्तर, ऊर्ध्व अतिरंजन, प्रकाश, रंग और घुमाव, भेजने या चिपकाने के लिए</translation>
    </message>
    <message>
        <source>Shaded, with a colour for each height</source>
        <translation>छायांकित, हर ऊँचाई का एक रंग</translation>
    </message>
    <message>
        <source>Shaded, with &amp;ambient occlusion</source>
        <translation>छायांकित, परिवेशी अवरोधन के साथ (&amp;A)</translation>
    </message>
    <message>
        <source>Shaded, and darker in hollows and grooves</source>
        <translation>छायांकित, और गड्ढों तथा खाँचों में गहरा</translation>
    </message>
    <message>
        <source>Finer resolution: a smaller window</source>
        <translation>और बारीक रिज़ॉल्यूशन: छोटी विंडो</translation>
    </message>
    <message>
        <source>Coarser resolution: a larger window</source>
        <translation>और मोटा रिज़ॉल्यूशन: बड़ी विंडो</translation>
    </message>
    <message>
        <source>Add book&amp;mark…</source>
        <translation>बुकमार्क जोड़ें (&amp;M)…</translation>
    </message>
    <message>
        <source>Keep the window under a name, to come back to it</source>
        <translation>विंडो को नाम देकर रखें, ताकि उस पर लौट सकें</translation>
    </message>
    <message>
        <source>Ne&amp;xt bookmark</source>
        <translation>अगला बुकमार्क (&amp;X)</translation>
    </message>
    <message>
        <source>Go to the next bookmark or marker</source>
        <translation>अगले बुकमार्क या चिह्न पर जाएँ</translation>
    </message>
    <message>
        <source>Pre&amp;vious bookmark</source>
        <translation>पिछला बुकमार्क (&amp;V)</translation>
    </message>
    <message>
        <source>Go to the bookmark or marker before this one</source>
        <translation>इससे पहले के बुकमार्क या चिह्न पर जाएँ</translation>
    </message>
    <message>
        <source>Bookmarks as conditions in random order, under letters, for one participant</source>
        <translation>एक प्रतिभागी के लिए, बुकमार्क शर्तों के रूप में, यादृच्छिक क्रम में और अक्षरों के नाम से</translation>
    </message>
    <message>
        <source>Open &amp;web address…</source>
        <translation>वेब पता खोलें (&amp;W)…</translation>
    </message>
    <message>
        <source>Open a map that was published on the web, by its address</source>
        <translation>वेब पर प्रकाशित मानचित्र को उसके पते से खोलें</translation>
    </message>
    <message>
        <source>&amp;Object turns with the view</source>
        <translation>वस्तु दृश्य के साथ घूमे (&amp;O)</translation>
    </message>
    <message>
        <source>While the view is turned, the relief is made anew again and again, and the hand feels the object turn</source>
        <translation>दृश्य घुमाते समय उभार बार-बार नया बनता है, और हाथ वस्तु का घूमना महसूस करता है</translation>
    </message>
    <message>
        <source>Map by &amp;tiles…</source>
        <translation>टाइलों से मानचित्र (&amp;T)…</translation>
    </message>
    <message>
        <source>Make the map of a scan that is larger than the memory</source>
        <translation>ऐसे स्कैन का मानचित्र बनाएँ जो मेमोरी से बड़ा है</translation>
    </message>
    <message>
        <source>Set up exhi&amp;bit…</source>
        <translation>प्रदर्शनी तैयार करें… (&amp;B)</translation>
    </message>
    <message>
        <source>What visitors of an exhibit are offered, and how it looks after them</source>
        <translation>प्रदर्शनी के आगंतुकों को क्या मिलता है, और वह उनका ध्यान कैसे रखती है</translation>
    </message>
    <message>
        <source>&amp;Feel with the mouse</source>
        <translation>माउस से महसूस करें (&amp;F)</translation>
    </message>
    <message>
        <source>The pointer is slower uphill and faster downhill, and larger on heights; Escape ends it</source>
        <translation>सूचक चढ़ाई पर धीमा, उतराई पर तेज़ और ऊँचाई पर बड़ा होता है; Escape इसे समाप्त करता है</translation>
    </message>
</context>
<context>
    <name>relievo::CommandWords</name>
    <message>
        <source>load import file read</source>
        <translation>लोड आयात फ़ाइल पढ़ें</translation>
    </message>
    <message>
        <source>load import directory images</source>
        <translation>लोड आयात निर्देशिका चित्र</translation>
    </message>
    <message>
        <source>store keep session</source>
        <translation>सहेजें रखें सत्र</translation>
    </message>
    <message>
        <source>export publish print paper PDF SVG TIFF screenshot</source>
        <translation>निर्यात प्रकाशन छपाई लेख PDF SVG TIFF</translation>
    </message>
    <message>
        <source>export screenshot snapshot picture photo PNG capture</source>
        <translation>निर्यात स्क्रीनशॉट तस्वीर फ़ोटो PNG</translation>
    </message>
    <message>
        <source>save as convert STL PLY OBJ glTF GeoTIFF mesh 3D print section profile</source>
        <translation>रूप बदलें STL PLY OBJ glTF GeoTIFF जाल 3D छपाई काट प्रोफ़ाइल</translation>
    </message>
    <message>
        <source>export archive zip share cite</source>
        <translation>निर्यात संग्रह zip साझा उद्धरण</translation>
    </message>
    <message>
        <source>end unload</source>
        <translation>समाप्त बंद</translation>
    </message>
    <message>
        <source>exit end</source>
        <translation>बाहर समाप्त</translation>
    </message>
    <message>
        <source>clean crop cut trim align register merge join thin decimate outliers noise edit cloud</source>
        <translation>साफ़ काटें छाँटें संरेखण जोड़ें मिलाएँ पतला शोर बिंदु संपादन</translation>
    </message>
    <message>
        <source>align rotate orient resolution grid holes fill rasterize crop clean</source>
        <translation>संरेखण घुमाएँ दिशा विभेदन जाली छेद भरें काटें साफ़</translation>
    </message>
    <message>
        <source>scale millimetres metres inches</source>
        <translation>पैमाना मिलीमीटर मीटर इंच</translation>
    </message>
    <message>
        <source>zoom all overview reset fit</source>
        <translation>ज़ूम सब अवलोकन वापस</translation>
    </message>
    <message>
        <source>zoom reset home straighten camera</source>
        <translation>ज़ूम वापस सीधा कैमरा</translation>
    </message>
    <message>
        <source>crop region coordinates selection go to</source>
        <translation>काटें क्षेत्र निर्देशांक चयन जाएँ</translation>
    </message>
    <message>
        <source>best feel where find interesting places</source>
        <translation>सर्वोत्तम स्पर्श कहाँ खोजें रोचक स्थान</translation>
    </message>
    <message>
        <source>rotate orbit spin</source>
        <translation>घुमाव परिक्रमा</translation>
    </message>
    <message>
        <source>rotate orbit tilt</source>
        <translation>घुमाव परिक्रमा झुकाव</translation>
    </message>
    <message>
        <source>align rotate orient plane</source>
        <translation>संरेखण घुमाव दिशा तल</translation>
    </message>
    <message>
        <source>align rotate orient level</source>
        <translation>संरेखण घुमाव दिशा समतल</translation>
    </message>
    <message>
        <source>rotate orbit mouse navigate</source>
        <translation>घुमाव माउस संचालन</translation>
    </message>
    <message>
        <source>feel press mouse haptic</source>
        <translation>महसूस दबाएँ माउस</translation>
    </message>
    <message>
        <source>mouse button mode tool</source>
        <translation>माउस बटन विधा औज़ार</translation>
    </message>
    <message>
        <source>light shadow oblique grazing</source>
        <translation>प्रकाश छाया तिरछा</translation>
    </message>
    <message>
        <source>light lamp reset</source>
        <translation>प्रकाश दीपक वापस</translation>
    </message>
    <message>
        <source>cross section cut line height curve</source>
        <translation>अनुप्रस्थ काट रेखा ऊँचाई वक्र</translation>
    </message>
    <message>
        <source>export curve plot SVG CSV</source>
        <translation>निर्यात वक्र SVG CSV</translation>
    </message>
    <message>
        <source>export table spreadsheet CSV</source>
        <translation>निर्यात सारणी CSV</translation>
    </message>
    <message>
        <source>help guide documentation handbook</source>
        <translation>सहायता मार्गदर्शिका प्रलेखन</translation>
    </message>
    <message>
        <source>help shortcuts hotkeys keyboard mouse</source>
        <translation>सहायता शॉर्टकट कीबोर्ड माउस</translation>
    </message>
    <message>
        <source>settings options configure language theme</source>
        <translation>विकल्प विन्यास भाषा रंग</translation>
    </message>
    <message>
        <source>compare same camera series next scan lock</source>
        <translation>तुलना वही कैमरा शृंखला अगला स्कैन</translation>
    </message>
    <message>
        <source>experiment participant trial blind randomize</source>
        <translation>प्रयोग प्रतिभागी परीक्षण यादृच्छिक</translation>
    </message>
    <message>
        <source>point cloud mesh raw 3D turn rotate orbit object arrow</source>
        <translation>बिंदु बादल जाल कच्चा 3D घुमाना वस्तु तीर</translation>
    </message>
    <message>
        <source>align rotate orient projection view direction</source>
        <translation>संरेखित घुमाना प्रक्षेप दृश्य दिशा</translation>
    </message>
    <message>
        <source>zoom in closer magnify level detail</source>
        <translation>ज़ूम पास बड़ा स्तर विवरण</translation>
    </message>
    <message>
        <source>zoom out farther level detail</source>
        <translation>ज़ूम दूर छोटा स्तर विवरण</translation>
    </message>
    <message>
        <source>place name save position favourite</source>
        <translation>जगह नाम स्थान सहेजें पसंदीदा</translation>
    </message>
    <message>
        <source>place position favourite</source>
        <translation>जगह स्थान पसंदीदा</translation>
    </message>
    <message>
        <source>internet network URL link online server remote https</source>
        <translation>इंटरनेट नेटवर्क URL लिंक ऑनलाइन सर्वर दूर https</translation>
    </message>
    <message>
        <source>rotate orbit object under the hand while touching live</source>
        <translation>घुमाना चक्कर वस्तु हाथ के नीचे छूते हुए</translation>
    </message>
    <message>
        <source>large huge out of core memory build pyramid survey site LAS</source>
        <translation>बड़ा विशाल मेमोरी पिरामिड सर्वेक्षण स्थल LAS</translation>
    </message>
    <message>
        <source>museum kiosk playlist visitors exhibition PIN</source>
        <translation>संग्रहालय कियोस्क सूची आगंतुक प्रदर्शनी PIN</translation>
    </message>
    <message>
        <source>pseudo-haptic cursor slow bumps holes touch</source>
        <translation>छद्म-हैप्टिक कर्सर धीमा उभार छेद स्पर्श</translation>
    </message>
</context>
<context>
    <name>relievo::DepthMapDialog</name>
    <message>
        <source>What the map is made of</source>
        <translation>मानचित्र किससे बना है</translation>
    </message>
    <message>
        <source>%1 of the cells are measured</source>
        <translation>%1 सेल मापे गए हैं</translation>
    </message>
    <message>
        <source>%1 interpolated</source>
        <translation>%1 अंतर्वेशित</translation>
    </message>
    <message>
        <source>%1 holes on the base plane</source>
        <translation>%1 छेद, आधार तल पर</translation>
    </message>
    <message>
        <source>%1 too steep</source>
        <translation>%1 बहुत तीव्र ढाल</translation>
    </message>
    <message>
        <source>%1 outside</source>
        <translation>%1 बाहर</translation>
    </message>
    <message>
        <source>No enclosed holes.</source>
        <translation>कोई घिरा हुआ छेद नहीं।</translation>
    </message>
    <message>
        <source>%1 (filled)</source>
        <translation>%1 (भरा)</translation>
    </message>
    <message>
        <source>Enclosed holes: %1, of %2 mm².</source>
        <translation>घिरे हुए छेद: %1, क्षेत्रफल %2 mm²।</translation>
    </message>
    <message>
        <source>Hidden from here: %1; undercut: %2; too steep: %3.</source>
        <translation>यहाँ से छिपा: %1; नीचे कटा: %2; बहुत तीव्र ढाल: %3।</translation>
    </message>
    <message>
        <source>%1 × %2 cells of %3, %4 levels; %5.</source>
        <translation>%3 के %1 × %2 सेल, %4 स्तर; %5।</translation>
    </message>
    <message>
        <source>Shares of the cells</source>
        <translation>सेलों के हिस्से</translation>
    </message>
    <message>
        <source>About this depth map</source>
        <translation>इस गहराई मानचित्र के बारे में</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>समस्या</translation>
    </message>
    <message>
        <source>L&amp;ive</source>
        <translation>साथ-साथ (&amp;I)</translation>
    </message>
    <message>
        <source>Sho&amp;w what was not measured</source>
        <translation>जो मापा नहीं गया वह दिखाएँ (&amp;W)</translation>
    </message>
    <message>
        <source>Recom&amp;pute</source>
        <translation>फिर से गणना (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>रोकें (&amp;S)</translation>
    </message>
    <message>
        <source>Depth map</source>
        <translation>गहराई मानचित्र</translation>
    </message>
    <message>
        <source>Recompute</source>
        <translation>फिर से गणना</translation>
    </message>
    <message>
        <source>Make the preview of the choices shown</source>
        <translation>दिखाए गए चुनावों का पूर्वावलोकन बनाएँ</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>रोकें</translation>
    </message>
    <message>
        <source>Stop the work; the picture before stays</source>
        <translation>काम रोकें; पहले का चित्र रहता है</translation>
    </message>
    <message>
        <source>Live preview</source>
        <translation>साथ-साथ पूर्वावलोकन</translation>
    </message>
    <message>
        <source>Make the preview anew after each change</source>
        <translation>हर बदलाव के बाद पूर्वावलोकन फिर बनाएँ</translation>
    </message>
    <message>
        <source>Show what was not measured</source>
        <translation>जो मापा नहीं गया वह दिखाएँ</translation>
    </message>
    <message>
        <source>Blue stripes: interpolated. Purple crosses: holes on the base plane. Orange: too steep</source>
        <translation>नीली धारियाँ: अंतर्वेशित। बैंगनी क्रॉस: आधार तल पर छेद। नारंगी: बहुत तीव्र ढाल</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>प्रगति</translation>
    </message>
    <message>
        <source>What is being done</source>
        <translation>क्या हो रहा है</translation>
    </message>
    <message>
        <source>Recom&amp;pute *</source>
        <translation>फिर से गणना (&amp;P) *</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Stray points left out: %1.</source>
        <translation>छोड़े गए भटके बिंदु: %1।</translation>
    </message>
</context>
<context>
    <name>relievo::DepthMapForm</name>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>फ़ाइल की इकाई (&amp;U)</translation>
    </message>
    <message>
        <source>Length unit of the file&apos;s coordinates</source>
        <translation>फ़ाइल के निर्देशांकों की लंबाई इकाई</translation>
    </message>
    <message>
        <source>Size in millimetres</source>
        <translation>आकार मिलीमीटर में</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>आकार</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>दृश्य (&amp;V)</translation>
    </message>
    <message>
        <source>From which side the object is seen</source>
        <translation>वस्तु किस ओर से देखी जाती है</translation>
    </message>
    <message>
        <source>As turned in the detail view</source>
        <translation>जैसा विवरण दृश्य में घुमाया</translation>
    </message>
    <message>
        <source>Turn about &amp;x</source>
        <translation>x के चारों ओर घुमाएँ (&amp;X)</translation>
    </message>
    <message>
        <source>Turn about &amp;y</source>
        <translation>y के चारों ओर घुमाएँ (&amp;Y)</translation>
    </message>
    <message>
        <source>Turn a&amp;bout z</source>
        <translation>z के चारों ओर घुमाएँ (&amp;B)</translation>
    </message>
    <message>
        <source>Right-handed, about the view&apos;s own axes, x first</source>
        <translation>दाहिने हाथ का नियम, दृश्य के अपने अक्षों पर, पहले x</translation>
    </message>
    <message>
        <source>The processor, or the graphics card&apos;s depth buffer as in the paper</source>
        <translation>प्रोसेसर, या लेख की तरह ग्राफ़िक्स कार्ड का गहराई बफ़र</translation>
    </message>
    <message>
        <source>Which height a cell gets from the points in it</source>
        <translation>सेल को उसके बिंदुओं से कौन-सी ऊँचाई मिलती है</translation>
    </message>
    <message>
        <source>From the data</source>
        <translation>आँकड़ों से</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>ग्रिड (&amp;G)</translation>
    </message>
    <message>
        <source>How fine the grid is</source>
        <translation>ग्रिड कितना बारीक है</translation>
    </message>
    <message>
        <source>Number of cells</source>
        <translation>सेलों की संख्या</translation>
    </message>
    <message>
        <source>Size of a cell</source>
        <translation>सेल का आकार</translation>
    </message>
    <message>
        <source>&amp;Cells</source>
        <translation>सेल (&amp;C)</translation>
    </message>
    <message>
        <source>Cells across the longer side</source>
        <translation>लंबी भुजा पर सेल</translation>
    </message>
    <message>
        <source>Cell si&amp;ze</source>
        <translation>सेल का आकार (&amp;Z)</translation>
    </message>
    <message>
        <source>Distance of neighbouring cells</source>
        <translation>पड़ोसी सेलों की दूरी</translation>
    </message>
    <message>
        <source>How much coarser each level of the pyramid is; 2 in the paper</source>
        <translation>पिरामिड का हर स्तर कितना मोटा है; लेख में 2</translation>
    </message>
    <message>
        <source>&amp;Holes</source>
        <translation>छेद (&amp;H)</translation>
    </message>
    <message>
        <source>What becomes of enclosed places where nothing was measured</source>
        <translation>जहाँ कुछ मापा नहीं गया उन घिरी जगहों का क्या हो</translation>
    </message>
    <message>
        <source>On the base plane</source>
        <translation>आधार तल पर</translation>
    </message>
    <message>
        <source>Interpolate up to</source>
        <translation>अंतर्वेशन, अधिकतम</translation>
    </message>
    <message>
        <source>Smooth membrane up to</source>
        <translation>चिकनी झिल्ली, अधिकतम</translation>
    </message>
    <message>
        <source>Leave open</source>
        <translation>खुला छोड़ें</translation>
    </message>
    <message>
        <source>&amp;Largest hole</source>
        <translation>सबसे बड़ा छेद (&amp;L)</translation>
    </message>
    <message>
        <source>Larger holes rest on the base plane</source>
        <translation>इससे बड़े छेद आधार तल पर रहते हैं</translation>
    </message>
    <message>
        <source>The lowest cell of the raster</source>
        <translation>ग्रिड का सबसे नीचा सेल</translation>
    </message>
    <message>
        <source>0.1 % of the measured cells lie below it</source>
        <translation>मापे गए सेलों का 0.1 % इससे नीचे है</translation>
    </message>
    <message>
        <source>Base plane</source>
        <translation>आधार तल</translation>
    </message>
    <message>
        <source>A height map keeps its cells and its view.</source>
        <translation>ऊँचाई मानचित्र अपने सेल और अपना दृश्य रखता है।</translation>
    </message>
    <message>
        <source>A map of this program is in millimetres.</source>
        <translation>इस प्रोग्राम का मानचित्र मिलीमीटर में होता है।</translation>
    </message>
    <message>
        <source>A map of this program has its holes treated already.</source>
        <translation>इस प्रोग्राम के मानचित्र में छेद पहले ही निपटाए गए हैं।</translation>
    </message>
    <message>
        <source>Triangles need no rule.</source>
        <translation>त्रिभुजों को नियम नहीं चाहिए।</translation>
    </message>
    <message>
        <source>The depth buffer keeps the front-most point.</source>
        <translation>गहराई बफ़र सबसे आगे का बिंदु रखता है।</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>अज्ञात</translation>
    </message>
    <message>
        <source>&amp;Far-off points</source>
        <translation>दूर के बिंदु (&amp;F)</translation>
    </message>
    <message>
        <source>Few points so far from all others that they stretch the map</source>
        <translation>थोड़े-से बिंदु जो बाकी सबसे इतने दूर हैं कि वे मानचित्र को खींच देते हैं</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>छोड़ दें</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>रखें</translation>
    </message>
    <message>
        <source>A height map has none.</source>
        <translation>ऊँचाई मानचित्र में ये नहीं होते।</translation>
    </message>
    <message>
        <source>Leave out, groups too</source>
        <translation>छोड़ दें, समूह भी</translation>
    </message>
    <message>
        <source>M&amp;ethod</source>
        <translation>विधि (&amp;E)</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>Height pe&amp;r cell</source>
        <translation>प्रति कोष्ठ ऊँचाई (&amp;R)</translation>
    </message>
    <message>
        <source>Pyra&amp;mid factor</source>
        <translation>पिरामिड गुणक (&amp;M)</translation>
    </message>
</context>
<context>
    <name>relievo::DepthMapPreview</name>
    <message>
        <source>Preview of the depth map</source>
        <translation>गहराई मानचित्र का पूर्वावलोकन</translation>
    </message>
    <message>
        <source>Of other choices than those shown</source>
        <translation>दिखाए गए से अलग चुनावों का</translation>
    </message>
    <message>
        <source>Of the choices shown</source>
        <translation>दिखाए गए चुनावों का</translation>
    </message>
    <message>
        <source>Not of these choices yet</source>
        <translation>अभी इन चुनावों का नहीं</translation>
    </message>
</context>
<context>
    <name>relievo::DetailView</name>
    <message>
        <source>Detail view</source>
        <translation>विवरण दृश्य</translation>
    </message>
    <message>
        <source>Move window</source>
        <translation>विंडो खिसकाएँ</translation>
    </message>
    <message>
        <source>The part inside the pink window. The pointer carries the hand just above the surface. What dragging does, F7 changes between the two: %1. %2; the wheel meanwhile presses deeper, and with another button held it changes the resolution. Keys: arrows, Page Down, Page Up.</source>
        <translation>गुलाबी विंडो के भीतर का भाग। सूचक हाथ को सतह के ठीक ऊपर ले जाता है। खींचने से क्या होता है, F7 दोनों के बीच बदलता है: %1। %2; उस समय पहिया और गहरा दबाता है, और दूसरा बटन भी दबा हो तो रिज़ॉल्यूशन बदलता है। कुंजियाँ: तीर, Page Down, Page Up।</translation>
    </message>
</context>
<context>
    <name>relievo::DeviceButtons</name>
    <message>
        <source>%1 connected.</source>
        <translation>%1 जुड़ा।</translation>
    </message>
    <message>
        <source>%1 disconnected.</source>
        <translation>%1 हटा।</translation>
    </message>
    <message>
        <source>%1?</source>
        <translation>%1?</translation>
    </message>
    <message>
        <source>Move mode. Push the grip to a side; Forward when you are there.</source>
        <translation>खिसकाने की विधा। ग्रिप को एक ओर धकेलें; पहुँचने पर आगे वाला बटन।</translation>
    </message>
    <message>
        <source>%1 is not possible here.</source>
        <translation>%1 यहाँ संभव नहीं।</translation>
    </message>
    <message>
        <source>%1 is plugged in but this account may not use it. Install the rule that &apos;relievo devices rule&apos; prints, once, then replug.</source>
        <translation>%1 जुड़ा है, पर इस खाते को उसके उपयोग की अनुमति नहीं है। &apos;relievo devices rule&apos; जो नियम छापता है उसे एक बार स्थापित करें, फिर दोबारा जोड़ें।</translation>
    </message>
    <message>
        <source>Forces are off.</source>
        <translation>बल बंद हैं।</translation>
    </message>
</context>
<context>
    <name>relievo::DeviceRows</name>
    <message>
        <source>Device</source>
        <translation>उपकरण</translation>
    </message>
    <message>
        <source>What the hand holds. A virtual hand is moved by the mouse and pushed by the force, as a real one is.</source>
        <translation>हाथ क्या पकड़े है। आभासी हाथ को माउस चलाता है और बल धकेलता है, जैसे असली हाथ को।</translation>
    </message>
    <message>
        <source>Whether somebody has tried such a device</source>
        <translation>क्या किसी ने ऐसा उपकरण आज़माया है</translation>
    </message>
    <message>
        <source>How warm the motors are</source>
        <translation>मोटर कितनी गरम हैं</translation>
    </message>
    <message>
        <source>Hold the grip&apos;s weig&amp;ht</source>
        <translation>ग्रिप का &amp;भार थामें</translation>
    </message>
    <message>
        <source>Hold the grip&apos;s weight</source>
        <translation>ग्रिप का भार थामें</translation>
    </message>
    <message>
        <source>While forces are on, the device holds its own grip, as heavy as the calibration found it. Nothing happens where it was not calibrated, or where the device does so by itself.</source>
        <translation>जब तक बल चालू हैं, उपकरण अपनी ग्रिप को उतने भार से थामता है जितना अंशांकन ने पाया। जहाँ अंशांकन नहीं हुआ या उपकरण स्वयं ऐसा करता है वहाँ कुछ नहीं होता।</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>उपकरण (&amp;D)</translation>
    </message>
    <message>
        <source>Tried on hardware: ask who made the plug-in.</source>
        <translation>वास्तविक उपकरण पर आज़माया गया: जिसने प्लग-इन बनाया, उससे पूछें।</translation>
    </message>
    <message>
        <source>Tried on hardware: never.</source>
        <translation>वास्तविक उपकरण पर आज़माया गया: कभी नहीं।</translation>
    </message>
    <message>
        <source>Tried on hardware: %1.</source>
        <translation>वास्तविक उपकरण पर आज़माया गया: %1।</translation>
    </message>
    <message>
        <source>%1 (not here now)</source>
        <translation>%1 (अभी यहाँ नहीं)</translation>
    </message>
    <message>
        <source>Before you, relief upright</source>
        <translation>आपके सामने, उभार खड़ा</translation>
    </message>
    <message>
        <source>Before you, relief flat</source>
        <translation>आपके सामने, उभार लेटा</translation>
    </message>
    <message>
        <source>At your left, turned to you</source>
        <translation>आपके बाईं ओर, आपकी तरफ़ मुड़ा</translation>
    </message>
    <message>
        <source>At your right, turned to you</source>
        <translation>आपके दाईं ओर, आपकी तरफ़ मुड़ा</translation>
    </message>
    <message>
        <source>How the device stands</source>
        <translation>उपकरण कैसे खड़ा है</translation>
    </message>
    <message>
        <source>Which way the grip is pushed to press: away from you, or down onto a relief that lies flat; or the device stands beside you. Forces go off when it changes. The mouse is the same in each.</source>
        <translation>दबाने के लिए ग्रिप किधर धकेली जाती है: आपसे दूर, या लेटे उभार पर नीचे; या उपकरण आपके बगल में है। बदलने पर बल बंद हो जाते हैं। माउस हर स्थिति में वही रहता है।</translation>
    </message>
    <message>
        <source>Grip posi&amp;tion</source>
        <translation>ग्रिप की स्थिति (&amp;T)</translation>
    </message>
</context>
<context>
    <name>relievo::DeviceSetupDialog</name>
    <message>
        <source>passed</source>
        <translation>सफल</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>असफल</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>नहीं दिखा</translation>
    </message>
    <message>
        <source>Device set-up</source>
        <translation>उपकरण की तैयारी</translation>
    </message>
    <message>
        <source>State of the Falcon</source>
        <translation>Falcon की अवस्था</translation>
    </message>
    <message>
        <source>&amp;Left-handed: plus and minus change sides</source>
        <translation>बाएँ हाथ के लिए: प्लस और माइनस जगह बदलते हैं (&amp;L)</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>बाएँ हाथ के लिए</translation>
    </message>
    <message>
        <source>&amp;Save and use the Falcon</source>
        <translation>सहेजें और Falcon का उपयोग करें (&amp;S)</translation>
    </message>
    <message>
        <source>Save and use the Falcon</source>
        <translation>सहेजें और Falcon का उपयोग करें</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>बंद करें</translation>
    </message>
    <message>
        <source>The rule is copied.</source>
        <translation>नियम की प्रति बन गई।</translation>
    </message>
    <message>
        <source>Test and calibration</source>
        <translation>जाँच और अंशांकन</translation>
    </message>
    <message>
        <source>Self &amp;test</source>
        <translation>स्व-जाँच (&amp;T)</translation>
    </message>
    <message>
        <source>Self test</source>
        <translation>स्व-जाँच</translation>
    </message>
    <message>
        <source>Weight for calibration in grams</source>
        <translation>अंशांकन का भार, ग्राम में</translation>
    </message>
    <message>
        <source> g</source>
        <translation> g</translation>
    </message>
    <message>
        <source>&amp;Weight</source>
        <translation>भार (&amp;W)</translation>
    </message>
    <message>
        <source>C&amp;alibrate</source>
        <translation>अंशांकन करें (&amp;A)</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>अंशांकन करें</translation>
    </message>
    <message>
        <source>Force gain</source>
        <translation>बल का गुणक</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>परिणाम</translation>
    </message>
    <message>
        <source>%1 counts per N mm</source>
        <translation>%1 गणना प्रति N mm</translation>
    </message>
    <message>
        <source>Falcon firmware</source>
        <translation>Falcon फ़र्मवेयर</translation>
    </message>
    <message>
        <source>Firmware (*.bin);;All files (*)</source>
        <translation>फ़र्मवेयर (*.bin);;सभी फ़ाइलें (*)</translation>
    </message>
    <message>
        <source>Unknown firmware</source>
        <translation>अनजान फ़र्मवेयर</translation>
    </message>
    <message>
        <source>The file has the form of a boot image, but nobody knows this one (sha256 %1). Load it into the Falcon all the same?</source>
        <translation>फ़ाइल बूट इमेज के रूप की है, पर इसे कोई नहीं जानता (sha256 %1)। फिर भी Falcon में लोड करें?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>रद्द करें</translation>
    </message>
    <message>
        <source>Contin&amp;ue</source>
        <translation>जारी रखें (&amp;U)</translation>
    </message>
    <message>
        <source>The computer goes to sleep; the forces are off and this has ended. Begin again when it is awake.</source>
        <translation>कंप्यूटर सोने जा रहा है; बल बंद हैं और यह समाप्त हो गया। उसके जागने पर फिर से शुरू करें।</translation>
    </message>
    <message>
        <source>Set up a &amp;Haply device…</source>
        <translation>Haply उपकरण तैयार करें… (&amp;H)</translation>
    </message>
    <message>
        <source>Set up a Haply device</source>
        <translation>Haply उपकरण तैयार करें</translation>
    </message>
</context>
<context>
    <name>relievo::DeviceTrustBox</name>
    <message>
        <source>They are being looked for.</source>
        <translation>उन्हें खोजा जा रहा है।</translation>
    </message>
    <message>
        <source>&amp;Look again</source>
        <translation>फिर खोजें (&amp;L)</translation>
    </message>
    <message>
        <source>Look for plug-ins again</source>
        <translation>प्लगइन फिर खोजें</translation>
    </message>
    <message>
        <source>None was found. Your own are looked for in %1.</source>
        <translation>कोई नहीं मिला। आपके अपने %1 में खोजे जाते हैं।</translation>
    </message>
    <message>
        <source>Its folder is trusted.</source>
        <translation>उसके फ़ोल्डर पर भरोसा है।</translation>
    </message>
    <message>
        <source>%1 may run</source>
        <translation>%1 चल सकता है</translation>
    </message>
    <message>
        <source>%1 may run from now on, until its file changes.</source>
        <translation>%1 अब से चल सकता है, जब तक उसकी फ़ाइल न बदले।</translation>
    </message>
    <message>
        <source>%1 may not run any more.</source>
        <translation>%1 अब नहीं चल सकता।</translation>
    </message>
</context>
<context>
    <name>relievo::Document</name>
    <message>
        <source>This map is read by tiles, as it was made; nothing was changed. To make it otherwise, run relievo depthmap --memory on its scan, with the choices you want.</source>
        <translation>यह मानचित्र टाइलों में, जैसा बना था वैसा ही पढ़ा जाता है; कुछ नहीं बदला गया। इसे दूसरे ढंग से बनाने के लिए इसके स्कैन पर अपने विकल्पों के साथ relievo depthmap --memory चलाएँ।</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>दृश्य घुमाएँ</translation>
    </message>
    <message>
        <source>Straighten the view</source>
        <translation>दृश्य सीधा करें</translation>
    </message>
</context>
<context>
    <name>relievo::ExhibitDialog</name>
    <message>
        <source>Pages</source>
        <translation>पन्ने</translation>
    </message>
    <message>
        <source>Is it whole?</source>
        <translation>क्या वह पूरी है?</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>समस्या</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>क्या ठीक नहीं</translation>
    </message>
    <message>
        <source>Enter or a double click goes to the place</source>
        <translation>Enter या डबल-क्लिक उस स्थान पर ले जाता है</translation>
    </message>
    <message>
        <source>Op&amp;en…</source>
        <translation>खोलें… (&amp;E)</translation>
    </message>
    <message>
        <source>Change an exhibit that is there</source>
        <translation>मौजूद प्रदर्शनी बदलें</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>सहेजें (&amp;S)</translation>
    </message>
    <message>
        <source>Keep the exhibit in its file</source>
        <translation>प्रदर्शनी को उसकी फ़ाइल में रखें</translation>
    </message>
    <message>
        <source>Sa&amp;ve as…</source>
        <translation>इस रूप में सहेजें… (&amp;V)</translation>
    </message>
    <message>
        <source>Keep the exhibit in another file</source>
        <translation>प्रदर्शनी को दूसरी फ़ाइल में रखें</translation>
    </message>
    <message>
        <source>Obje&amp;cts</source>
        <translation>वस्तुएँ (&amp;C)</translation>
    </message>
    <message>
        <source>V&amp;isit</source>
        <translation>भेंट (&amp;I)</translation>
    </message>
    <message>
        <source>%1 has faults. What they stand at is as it would be if nothing were said: %2</source>
        <translation>%1 में दोष हैं। जिन बातों में दोष हैं, वे ऐसी हैं मानो कुछ न कहा गया हो: %2</translation>
    </message>
    <message>
        <source>Exhibit[*]</source>
        <translation>प्रदर्शनी[*]</translation>
    </message>
    <message>
        <source>Exhibit %1[*]</source>
        <translation>प्रदर्शनी %1[*]</translation>
    </message>
    <message>
        <source>It cannot be shown yet; this is missing or wrong:</source>
        <translation>वह अभी दिखाई नहीं जा सकती; यह कमी या गलती है:</translation>
    </message>
    <message>
        <source>It is whole. Once it is saved, it can be shown.</source>
        <translation>वह पूरी है। सहेजने के बाद दिखाई जा सकती है।</translation>
    </message>
    <message>
        <source>It is whole. This shows it: %1</source>
        <translation>वह पूरी है। यह उसे दिखाता है: %1</translation>
    </message>
    <message>
        <source>Exhibit</source>
        <translation>प्रदर्शनी</translation>
    </message>
    <message>
        <source>Exhibits (*.json)</source>
        <translation>प्रदर्शनियाँ (*.json)</translation>
    </message>
    <message>
        <source>Save exhibit</source>
        <translation>प्रदर्शनी सहेजें</translation>
    </message>
    <message>
        <source>Unsaved exhibit</source>
        <translation>न सहेजी प्रदर्शनी</translation>
    </message>
    <message>
        <source>What was changed in the exhibit is in no file yet.</source>
        <translation>प्रदर्शनी में जो बदला गया, वह अभी किसी फ़ाइल में नहीं है।</translation>
    </message>
    <message>
        <source>Object %1: %2</source>
        <translation>वस्तु %1: %2</translation>
    </message>
    <message>
        <source>Nothing is missing. The objects are being opened to see whether they can be.</source>
        <translation>कुछ भी कमी नहीं है। यह देखने के लिए कि वस्तुएँ खुलती हैं या नहीं, उन्हें खोला जा रहा है।</translation>
    </message>
</context>
<context>
    <name>relievo::ExhibitObjectsPage</name>
    <message>
        <source>Objects</source>
        <translation>वस्तुएँ</translation>
    </message>
    <message>
        <source>What visitors are offered, in this order</source>
        <translation>आगंतुकों को क्या मिलता है, इस क्रम में</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>जोड़ें… (&amp;A)</translation>
    </message>
    <message>
        <source>Take scans, height maps or projects into the list</source>
        <translation>स्कैन, ऊँचाई मानचित्र या परियोजनाएँ सूची में लें</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>हटाएँ (&amp;R)</translation>
    </message>
    <message>
        <source>Take the object out of the list</source>
        <translation>वस्तु को सूची से हटाएँ</translation>
    </message>
    <message>
        <source>U&amp;p</source>
        <translation>ऊपर (&amp;P)</translation>
    </message>
    <message>
        <source>Offer the object earlier</source>
        <translation>वस्तु पहले दें</translation>
    </message>
    <message>
        <source>Dow&amp;n</source>
        <translation>नीचे (&amp;N)</translation>
    </message>
    <message>
        <source>Offer the object later</source>
        <translation>वस्तु बाद में दें</translation>
    </message>
    <message>
        <source>File</source>
        <translation>फ़ाइल</translation>
    </message>
    <message>
        <source>A scan, a height map or a project</source>
        <translation>स्कैन, ऊँचाई मानचित्र या परियोजना</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>ब्राउज़ करें… (&amp;B)</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>दूसरी फ़ाइल चुनें</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>फ़ाइल की इकाई</translation>
    </message>
    <message>
        <source>Length unit of the file&apos;s coordinates</source>
        <translation>फ़ाइल के निर्देशांकों की लंबाई इकाई</translation>
    </message>
    <message>
        <source>View</source>
        <translation>दृश्य</translation>
    </message>
    <message>
        <source>From which side the object is touched</source>
        <translation>वस्तु किस ओर से छुई जाती है</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>पाठ</translation>
    </message>
    <message>
        <source>What is said and shown, in each language</source>
        <translation>हर भाषा में क्या कहा और दिखाया जाता है</translation>
    </message>
    <message>
        <source>Title, %1</source>
        <translation>शीर्षक, %1</translation>
    </message>
    <message>
        <source>At most %1 words, spoken and shown</source>
        <translation>अधिकतम %1 शब्द, बोले और दिखाए जाते हैं</translation>
    </message>
    <message>
        <source>Description, %1</source>
        <translation>विवरण, %1</translation>
    </message>
    <message>
        <source>At most %1 words, spoken after the title; in every language or in none</source>
        <translation>अधिकतम %1 शब्द, शीर्षक के बाद बोले जाते हैं; हर भाषा में या किसी में नहीं</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>शीर्षक (&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Description</source>
        <translation>विवरण (&amp;D)</translation>
    </message>
    <message>
        <source>Objects of the exhibit</source>
        <translation>प्रदर्शनी की वस्तुएँ</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>वस्तुएँ (&amp;O)</translation>
    </message>
    <message>
        <source>From the file</source>
        <translation>फ़ाइल से</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>फ़ाइल (&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>फ़ाइल की इकाई (&amp;U)</translation>
    </message>
    <message>
        <source>Vie&amp;w</source>
        <translation>दृश्य (&amp;W)</translation>
    </message>
    <message>
        <source>Object of the exhibit</source>
        <translation>प्रदर्शनी की वस्तु</translation>
    </message>
    <message>
        <source>No file</source>
        <translation>कोई फ़ाइल नहीं</translation>
    </message>
</context>
<context>
    <name>relievo::ExhibitVisitPage</name>
    <message>
        <source>Language of a new visitor</source>
        <translation>नए आगंतुक की भाषा</translation>
    </message>
    <message>
        <source>The first that is offered, and in which all begins</source>
        <translation>वह पहली भाषा जो दी जाती है और जिसमें सब शुरू होता है</translation>
    </message>
    <message>
        <source>Ask whether somebody is there after</source>
        <translation>कोई है या नहीं, यह पूछें, इतने समय बाद</translation>
    </message>
    <message>
        <source>Seconds without any input</source>
        <translation>बिना किसी इनपुट के सेकंड</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Begin anew after</source>
        <translation>नए सिरे से शुरू करें, इतने समय बाद</translation>
    </message>
    <message>
        <source>Seconds after the question</source>
        <translation>प्रश्न के बाद सेकंड</translation>
    </message>
    <message>
        <source>Chime every</source>
        <translation>घंटी हर</translation>
    </message>
    <message>
        <source>Seconds between chimes while nobody is there: 10 to 3600, or none</source>
        <translation>जब कोई न हो, घंटियों के बीच सेकंड: 10 से 3600, या कोई नहीं</translation>
    </message>
    <message>
        <source>Volume of a new visitor</source>
        <translation>नए आगंतुक के लिए ध्वनि-स्तर</translation>
    </message>
    <message>
        <source>Buttons change it until the visit ends</source>
        <translation>बटन इसे भेंट के अंत तक बदलते हैं</translation>
    </message>
    <message>
        <source>Loudest</source>
        <translation>सबसे ऊँचा</translation>
    </message>
    <message>
        <source>No button goes above it; how loud it is depends on the loudspeaker</source>
        <translation>कोई बटन इससे ऊपर नहीं जाता; यह कितना ऊँचा है, यह लाउडस्पीकर पर निर्भर है</translation>
    </message>
    <message>
        <source>Words a minute</source>
        <translation>प्रति मिनट शब्द</translation>
    </message>
    <message>
        <source>How fast the voice speaks</source>
        <translation>आवाज़ कितनी तेज़ बोलती है</translation>
    </message>
    <message>
        <source>Languages</source>
        <translation>भाषाएँ</translation>
    </message>
    <message>
        <source>Offered to visitors</source>
        <translation>आगंतुकों को दी जाती है</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>प्रतीक्षा</translation>
    </message>
    <message>
        <source>None</source>
        <translation>कोई नहीं</translation>
    </message>
    <message>
        <source>Voice</source>
        <translation>आवाज़</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>स्पर्श</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>उपकरण</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>प्रबलता</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>सबसे बड़ा बल</translation>
    </message>
    <message>
        <source>Sounds of touch</source>
        <translation>स्पर्श की ध्वनियाँ</translation>
    </message>
    <message>
        <source>Staff</source>
        <translation>कर्मचारी</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>चुनें… (&amp;H)</translation>
    </message>
    <message>
        <source>Choose the folder of counts and logs</source>
        <translation>गणनाओं और लॉग का फ़ोल्डर चुनें</translation>
    </message>
    <message>
        <source>New PIN of the staff</source>
        <translation>कर्मचारियों का नया PIN</translation>
    </message>
    <message>
        <source>Folder of counts and logs</source>
        <translation>गणनाओं और लॉग का फ़ोल्डर</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>अभी कोई नहीं</translation>
    </message>
    <message>
        <source>Stays as it is</source>
        <translation>जैसा है वैसा रहेगा</translation>
    </message>
    <message>
        <source>falcon, mouse, or what the panel Touch calls the device</source>
        <translation>falcon, mouse, या पैनल &apos;स्पर्श&apos; उपकरण को जो कहता है</translation>
    </message>
    <message>
        <source>How much of every force is felt</source>
        <translation>हर बल का कितना भाग महसूस होता है</translation>
    </message>
    <message>
        <source>Their volume; 0: none</source>
        <translation>उनका ध्वनि-स्तर; 0: कोई नहीं</translation>
    </message>
    <message>
        <source>No force is larger</source>
        <translation>कोई बल इससे बड़ा नहीं</translation>
    </message>
    <message>
        <source>Begin with the introduction</source>
        <translation>परिचय से शुरू करें</translation>
    </message>
    <message>
        <source>Each visitor&apos;s first object begins with two shapes to feel</source>
        <translation>हर आगंतुक की पहली वस्तु दो आकृतियों को छूने से शुरू होती है</translation>
    </message>
    <message>
        <source>Offer to lead the hand</source>
        <translation>हाथ को ले चलने का प्रस्ताव दें</translation>
    </message>
    <message>
        <source>Once round the outline, with a device that can</source>
        <translation>रूपरेखा के चारों ओर एक बार, ऐसे उपकरण से जो यह कर सके</translation>
    </message>
    <message>
        <source>Taps say what sounds say</source>
        <translation>थपकियाँ वही कहती हैं जो ध्वनियाँ</translation>
    </message>
    <message>
        <source>For who hears neither sounds nor speech</source>
        <translation>उनके लिए जो न ध्वनियाँ सुनते हैं न भाषण</translation>
    </message>
    <message>
        <source>One button does all</source>
        <translation>एक बटन से सब</translation>
    </message>
    <message>
        <source>For a foot switch or another single switch</source>
        <translation>पैर के स्विच या किसी अकेले स्विच के लिए</translation>
    </message>
    <message>
        <source>4 to 12 digits. The file keeps a checksum of them, not the digits</source>
        <translation>4 से 12 अंक। फ़ाइल उनका चेकसम रखती है, अंक नहीं</translation>
    </message>
    <message>
        <source>Empty: a folder of the account that shows the exhibit</source>
        <translation>खाली: उस खाते का फ़ोल्डर जो प्रदर्शनी दिखाता है</translation>
    </message>
    <message>
        <source>Loudest in the room</source>
        <translation>कमरे में सबसे ऊँची आवाज़</translation>
    </message>
    <message>
        <source>The same on a loudspeaker; the volume falls to it where headphones are pulled out</source>
        <translation>लाउडस्पीकर पर वही; हेडफ़ोन निकाले जाने पर आवाज़ इसी तक घट जाती है</translation>
    </message>
    <message>
        <source>The same</source>
        <translation>वही</translation>
    </message>
</context>
<context>
    <name>relievo::ExportController</name>
    <message>
        <source>Cancelled. Nothing was exported.</source>
        <translation>रद्द किया गया। कुछ निर्यात नहीं किया गया।</translation>
    </message>
    <message>
        <source>%1 x %2 pixels; File &gt; Image asks for others</source>
        <translation>%1 x %2 पिक्सेल; फ़ाइल &gt; चित्र दूसरे पूछता है</translation>
    </message>
    <message>
        <source>Picture of the detail view (.png)</source>
        <translation>विवरण दृश्य का चित्र (.png)</translation>
    </message>
    <message>
        <source>Picture of the whole object (.png)</source>
        <translation>पूरी वस्तु का चित्र (.png)</translation>
    </message>
    <message>
        <source>Profile %1, drawing (.svg)</source>
        <translation>प्रोफ़ाइल %1, रेखाचित्र (.svg)</translation>
    </message>
    <message>
        <source>Profile %1, numbers (.csv)</source>
        <translation>प्रोफ़ाइल %1, संख्याएँ (.csv)</translation>
    </message>
    <message>
        <source>Section %1, drawing (.svg)</source>
        <translation>काट %1, रेखाचित्र (.svg)</translation>
    </message>
    <message>
        <source>Section %1, numbers (.csv)</source>
        <translation>काट %1, संख्याएँ (.csv)</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 सहेजी गई</translation>
    </message>
</context>
<context>
    <name>relievo::ExportDialog</name>
    <message>
        <source>Format</source>
        <translation>प्रारूप</translation>
    </message>
    <message>
        <source>What the other program reads</source>
        <translation>दूसरा प्रोग्राम क्या पढ़ता है</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>भाग</translation>
    </message>
    <message>
        <source>How much of the map is written</source>
        <translation>मानचित्र का कितना भाग लिखा जाए</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>निर्देशांक</translation>
    </message>
    <message>
        <source>In which coordinates and unit heights are written</source>
        <translation>ऊँचाइयाँ किन निर्देशांकों और किस इकाई में लिखी जाएँ</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>निर्यात</translation>
    </message>
    <message>
        <source>File</source>
        <translation>फ़ाइल</translation>
    </message>
    <message>
        <source>Where it is written</source>
        <translation>कहाँ लिखा जाए</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>आकार</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>ढूँढें (&amp;B)…</translation>
    </message>
    <message>
        <source>Browse</source>
        <translation>ढूँढें</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>दूसरी जगह चुनें</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>प्रारूप (&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Part</source>
        <translation>भाग (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>फ़ाइल (&amp;F)</translation>
    </message>
    <message>
        <source>Cloud-optimised GeoTIFF (.tif)</source>
        <translation>क्लाउड-अनुकूल GeoTIFF (.tif)</translation>
    </message>
    <message>
        <source>GeoTIFF that relievo opens again (.tif)</source>
        <translation>GeoTIFF जिसे relievo फिर खोलता है (.tif)</translation>
    </message>
    <message>
        <source>Mesh for web viewers, glTF (.glb)</source>
        <translation>वेब दर्शकों के लिए जाल, glTF (.glb)</translation>
    </message>
    <message>
        <source>Mesh, PLY (.ply)</source>
        <translation>जाल, PLY (.ply)</translation>
    </message>
    <message>
        <source>Plate to print, STL (.stl)</source>
        <translation>छापने की पट्टिका, STL (.stl)</translation>
    </message>
    <message>
        <source>Points as text (.xyz)</source>
        <translation>पाठ के रूप में बिंदु (.xyz)</translation>
    </message>
    <message>
        <source>ESRI ASCII grid (.asc)</source>
        <translation>ESRI ASCII ग्रिड (.asc)</translation>
    </message>
    <message>
        <source>VTK image (.vti)</source>
        <translation>VTK चित्र (.vti)</translation>
    </message>
    <message>
        <source>Whole map</source>
        <translation>पूरा मानचित्र</translation>
    </message>
    <message>
        <source>Window, 200 x 200 samples</source>
        <translation>विंडो, 200 x 200 नमूने</translation>
    </message>
    <message>
        <source>Millimetres above the base plane</source>
        <translation>आधार तल से ऊपर मिलीमीटर</translation>
    </message>
    <message>
        <source>Those of the file</source>
        <translation>फ़ाइल के निर्देशांक</translation>
    </message>
    <message>
        <source>%1 x %2 cells, about %3</source>
        <translation>%1 x %2 कक्ष, लगभग %3</translation>
    </message>
    <message>
        <source>Coor&amp;dinates</source>
        <translation>निर्देशांक (&amp;D)</translation>
    </message>
    <message>
        <source>as long as its lines</source>
        <translation>अपनी रेखाओं जितना</translation>
    </message>
    <message>
        <source>Whole map, resolution %1 of %2</source>
        <translation>पूरा मानचित्र, रिज़ॉल्यूशन %2 में से %1</translation>
    </message>
</context>
<context>
    <name>relievo::FalconStatusAnnouncer</name>
    <message>
        <source>Top arm found.</source>
        <translation>ऊपरी भुजा मिली।</translation>
    </message>
    <message>
        <source>Right arm found.</source>
        <translation>दाईं भुजा मिली।</translation>
    </message>
    <message>
        <source>Left arm found.</source>
        <translation>बाईं भुजा मिली।</translation>
    </message>
    <message>
        <source>Touch &gt; Device set-up &gt; Firmware file takes one.</source>
        <translation>स्पर्श &gt; उपकरण की तैयारी &gt; फ़र्मवेयर फ़ाइल से एक दी जा सकती है।</translation>
    </message>
</context>
<context>
    <name>relievo::FeelForm</name>
    <message>
        <source>S&amp;urface</source>
        <translation>सतह (&amp;U)</translation>
    </message>
    <message>
        <source>Sh&amp;ape</source>
        <translation>आकार (&amp;A)</translation>
    </message>
    <message>
        <source>Prox&amp;y</source>
        <translation>प्रॉक्सी (&amp;Y)</translation>
    </message>
    <message>
        <source>Stiff&amp;ness</source>
        <translation>कठोरता (&amp;N)</translation>
    </message>
    <message>
        <source>Fr&amp;iction</source>
        <translation>घर्षण (&amp;I)</translation>
    </message>
    <message>
        <source>Dam&amp;ping</source>
        <translation>अवमंदन (&amp;P)</translation>
    </message>
    <message>
        <source>Not measure&amp;d</source>
        <translation>मापा नहीं गया (&amp;D)</translation>
    </message>
    <message>
        <source>Edge &amp;cue</source>
        <translation>किनारे का संकेत (&amp;C)</translation>
    </message>
    <message>
        <source>Te&amp;xture</source>
        <translation>बनावट (&amp;X)</translation>
    </message>
    <message>
        <source>Co&amp;ntact impulse</source>
        <translation>स्पर्श का आवेग (&amp;N)</translation>
    </message>
    <message>
        <source>Ma&amp;gnet</source>
        <translation>चुंबक (&amp;G)</translation>
    </message>
    <message>
        <source>How the surface feels</source>
        <translation>सतह कैसी लगती है</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>चिकनी</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>सटीक</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>लेख की तरह</translation>
    </message>
    <message>
        <source>Soft stone</source>
        <translation>नरम पत्थर</translation>
    </message>
    <message>
        <source>Bronze</source>
        <translation>काँसा</translation>
    </message>
    <message>
        <source>Own values</source>
        <translation>अपने मान</translation>
    </message>
    <message>
        <source>Sets shape, proxy, stiffness, friction and damping together. Each can be changed afterwards.</source>
        <translation>आकार, प्रॉक्सी, कठोरता, घर्षण और अवमंदन साथ में रखता है। बाद में हर एक बदला जा सकता है।</translation>
    </message>
    <message>
        <source>Shape of the surface between the samples</source>
        <translation>नमूनों के बीच सतह का आकार</translation>
    </message>
    <message>
        <source>Smooth with walls</source>
        <translation>दीवारों के साथ चिकना</translation>
    </message>
    <message>
        <source>Smooth everywhere</source>
        <translation>हर जगह चिकना</translation>
    </message>
    <message>
        <source>Flat facets (exact)</source>
        <translation>समतल फलक (सटीक)</translation>
    </message>
    <message>
        <source>The height samples are exact in each; only what lies between them differs.</source>
        <translation>ऊँचाई के नमूने हर एक में सटीक हैं; अंतर केवल उनके बीच है।</translation>
    </message>
    <message>
        <source>How the proxy follows the hand</source>
        <translation>प्रॉक्सी हाथ का अनुसरण कैसे करता है</translation>
    </message>
    <message>
        <source>Converged (exact)</source>
        <translation>अभिसरित (सटीक)</translation>
    </message>
    <message>
        <source>As in the paper (eq. 2)</source>
        <translation>लेख की तरह (समी. 2)</translation>
    </message>
    <message>
        <source>Successive approximation (paper)</source>
        <translation>क्रमिक सन्निकटन (लेख)</translation>
    </message>
    <message>
        <source>The proxy is the point that stays on the surface.</source>
        <translation>प्रॉक्सी वह बिंदु है जो सतह पर रहता है।</translation>
    </message>
    <message>
        <source>Friction at rest, 0 to 1</source>
        <translation>स्थिर घर्षण, 0 से 1</translation>
    </message>
    <message>
        <source>Force along the surface that holds the hand, as a part of the force against it; three quarters of it while sliding. The paper&apos;s proxies know none.</source>
        <translation>सतह के साथ का बल जो हाथ को रोकता है, सतह के विरुद्ध बल के अंश में; फिसलते समय उसका तीन-चौथाई। लेख के प्रॉक्सी में घर्षण नहीं है।</translation>
    </message>
    <message>
        <source>Damping in newton seconds per metre</source>
        <translation>अवमंदन न्यूटन सेकंड प्रति मीटर में</translation>
    </message>
    <message>
        <source> N s/m</source>
        <translation> N s/m</translation>
    </message>
    <message>
        <source>Against the speed of pressing in.</source>
        <translation>भीतर दबने की गति के विरुद्ध।</translation>
    </message>
    <message>
        <source>as the &amp;level suggests</source>
        <translation>जैसा स्तर सुझाए (&amp;L)</translation>
    </message>
    <message>
        <source>Stiffness as the level suggests</source>
        <translation>कठोरता जैसा स्तर सुझाए</translation>
    </message>
    <message>
        <source>Stiffness in newtons per millimetre</source>
        <translation>कठोरता न्यूटन प्रति मिलीमीटर में</translation>
    </message>
    <message>
        <source> N/mm</source>
        <translation> N/mm</translation>
    </message>
    <message>
        <source>Force per millimetre that the hand is pressed in.</source>
        <translation>हाथ जितने मिलीमीटर भीतर दबा है, प्रति मिलीमीटर बल।</translation>
    </message>
    <message>
        <source>Stiffness of ground that was not measured, in percent</source>
        <translation>बिना मापी जगह की कठोरता, प्रतिशत में</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How stiff filled gaps and the base plane are, as a part of the stiffness of measured ground. 100 %: no difference.</source>
        <translation>भरे अंतराल और आधार तल कितने कठोर हैं, मापी जगह की कठोरता के अंश में। 100 %: कोई अंतर नहीं।</translation>
    </message>
    <message>
        <source>Edge cue at the border of measured ground, in newtons</source>
        <translation>मापी जगह के किनारे का संकेत, न्यूटन में</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Texture of the next finer level, in micrometres of hand</source>
        <translation>अगले बारीक स्तर की बनावट, हाथ के माइक्रोमीटर में</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>How much of the next finer level is felt, at most, on top of the level that is touched. 0: none.</source>
        <translation>छुए जा रहे स्तर के ऊपर अगला बारीक स्तर अधिकतम कितना महसूस हो। 0: कुछ नहीं।</translation>
    </message>
    <message>
        <source>Contact impulse, in newtons at most</source>
        <translation>स्पर्श का आवेग, अधिकतम न्यूटन में</translation>
    </message>
    <message>
        <source>Pull toward the surface, in newtons at most</source>
        <translation>सतह की ओर खिंचाव, अधिकतम न्यूटन में</translation>
    </message>
    <message>
        <source>A gentle pull that begins 3 mm above the surface and ends on it. 0: none.</source>
        <translation>हल्का खिंचाव जो सतह से 3 mm ऊपर शुरू होकर उस पर समाप्त होता है। 0: कोई नहीं।</translation>
    </message>
    <message>
        <source>0.8 N/mm at resolution 1 and 2, 0.6 at 3, 0.5 at finer ones. What is set here is then the shown level&apos;s own.</source>
        <translation>रिज़ॉल्यूशन 1 और 2 पर 0.8 N/mm, 3 पर 0.6, बारीक पर 0.5। यहाँ रखा मान फिर दिखाए गए स्तर का अपना होता है।</translation>
    </message>
    <message>
        <source>A faint cue on the way from measured ground to other ground, and back. 0: none.</source>
        <translation>मापी जगह से दूसरी जगह और वापस जाते समय हल्का संकेत। 0: कोई नहीं।</translation>
    </message>
    <message>
        <source>A short impulse as hard as the hand comes. 0: none.</source>
        <translation>हाथ जितनी ज़ोर से आए उतना छोटा आवेग। 0: कोई नहीं।</translation>
    </message>
</context>
<context>
    <name>relievo::FeltPatterns</name>
    <message>
        <source>Felt patterns on: one tap is yes, two not measured, three the edge.</source>
        <translation>स्पर्श संकेत चालू: एक थपकी हाँ, दो मापा नहीं गया, तीन किनारा।</translation>
    </message>
    <message>
        <source>Felt patterns off.</source>
        <translation>स्पर्श संकेत बंद।</translation>
    </message>
</context>
<context>
    <name>relievo::FigureDialog</name>
    <message>
        <source>There is not enough memory for this figure. Nothing was written.</source>
        <translation>इस चित्र के लिए मेमोरी पर्याप्त नहीं है। कुछ नहीं लिखा गया।</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>रोकें (&amp;P)</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>चित्र</translation>
    </message>
    <message>
        <source>Preview of the figure</source>
        <translation>चित्र का पूर्वावलोकन</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>आकार</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>समस्या</translation>
    </message>
    <message>
        <source>Caption</source>
        <translation>चित्र-शीर्षक</translation>
    </message>
    <message>
        <source>The text that belongs under this figure</source>
        <translation>इस चित्र के नीचे का पाठ</translation>
    </message>
    <message>
        <source>Cop&amp;y caption</source>
        <translation>शीर्षक की प्रति (&amp;Y)</translation>
    </message>
    <message>
        <source>Copy caption</source>
        <translation>शीर्षक की प्रति</translation>
    </message>
    <message>
        <source>Put the caption into the clipboard</source>
        <translation>शीर्षक को क्लिपबोर्ड में रखें</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>प्रगति</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>रोकें</translation>
    </message>
    <message>
        <source>%1 × %2 mm on paper, %3 × %4 pixels, scale 1 : %5</source>
        <translation>काग़ज़ पर %1 × %2 mm, %3 × %4 पिक्सेल, पैमाना 1 : %5</translation>
    </message>
    <message>
        <source>. Parallax %1° of %2° with %3° between the eyes</source>
        <translation>। लंबन %2° में से %1°, आँखों के बीच %3°</translation>
    </message>
    <message>
        <source>Stopped. Nothing was written.</source>
        <translation>रोका गया। कुछ नहीं लिखा गया।</translation>
    </message>
    <message>
        <source>There is no folder %1. Nothing was written. Choose another, or make it.</source>
        <translation>फ़ोल्डर %1 नहीं है। कुछ नहीं लिखा गया। दूसरा चुनें, या उसे बनाएँ।</translation>
    </message>
    <message>
        <source>Replace figure</source>
        <translation>चित्र बदलें</translation>
    </message>
    <message>
        <source>%1 exists already in %2. Replace it?</source>
        <translation>%1 पहले से %2 में है। बदलें?</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>बदलें (&amp;R)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>बदलें</translation>
    </message>
    <message>
        <source>These files exist already. Replace them?</source>
        <translation>ये फ़ाइलें पहले से हैं। बदलें?</translation>
    </message>
    <message>
        <source>Stopped. Only this was written: %1.</source>
        <translation>रोका गया। केवल यह लिखा गया: %1।</translation>
    </message>
    <message>
        <source>Stop the work; no further file is written</source>
        <translation>काम रोकें; कोई और फ़ाइल नहीं लिखी जाएगी</translation>
    </message>
</context>
<context>
    <name>relievo::FigureForm</name>
    <message>
        <source>Browse: %1</source>
        <translation>ब्राउज़ करें: %1</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>दूसरी जगह चुनें</translation>
    </message>
    <message>
        <source>Shaded relief</source>
        <translation>छायांकित उभार</translation>
    </message>
    <message>
        <source>Height in colour</source>
        <translation>रंग में ऊँचाई</translation>
    </message>
    <message>
        <source>Hillshade</source>
        <translation>पहाड़ी छाया</translation>
    </message>
    <message>
        <source>Hillshade, four lights</source>
        <translation>पहाड़ी छाया, चार प्रकाश</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>ढाल</translation>
    </message>
    <message>
        <source>Local relief</source>
        <translation>स्थानीय उभार</translation>
    </message>
    <message>
        <source>Sky-view factor</source>
        <translation>आकाश-दृश्य गुणांक</translation>
    </message>
    <message>
        <source>Openness</source>
        <translation>खुलापन</translation>
    </message>
    <message>
        <source>Deviation, several scales</source>
        <translation>विचलन, कई पैमाने</translation>
    </message>
    <message>
        <source>Curvature, several scales</source>
        <translation>वक्रता, कई पैमाने</translation>
    </message>
    <message>
        <source>Natural colours</source>
        <translation>प्राकृतिक रंग</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>तीव्रता</translation>
    </message>
    <message>
        <source>Rel&amp;ief</source>
        <translation>उभार (&amp;I)</translation>
    </message>
    <message>
        <source>How heights are painted</source>
        <translation>ऊँचाइयाँ कैसे रंगी जाती हैं</translation>
    </message>
    <message>
        <source>This scan has none</source>
        <translation>इस स्कैन में कोई नहीं है</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>रंग</translation>
    </message>
    <message>
        <source>Even steps of lightness, also for colour-blind readers</source>
        <translation>उजाले के समान चरण, रंगांध पाठकों के लिए भी</translation>
    </message>
    <message>
        <source>Light from</source>
        <translation>प्रकाश की दिशा</translation>
    </message>
    <message>
        <source>0 is above, clockwise; 315 is the upper left</source>
        <translation>0 ऊपर है, घड़ी की दिशा में; 315 ऊपर बाएँ</translation>
    </message>
    <message>
        <source>Light&apos;s height</source>
        <translation>प्रकाश की ऊँचाई</translation>
    </message>
    <message>
        <source>Low light brings out worn detail</source>
        <translation>नीचा प्रकाश घिसे विवरण उभारता है</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>त्रिज्या</translation>
    </message>
    <message>
        <source>Of the neighbourhood that this relief image looks at</source>
        <translation>उस पड़ोस का, जिसे यह उभार-चित्र देखता है</translation>
    </message>
    <message>
        <source>10 samples</source>
        <translation>10 नमूने</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>छायांकन</translation>
    </message>
    <message>
        <source>How much relief shading natural colours and intensity get</source>
        <translation>प्राकृतिक रंग और तीव्रता में उभार का कितना छायांकन मिले</translation>
    </message>
    <message>
        <source>O&amp;wn ends of the colours</source>
        <translation>रंगों के अपने छोर (&amp;W)</translation>
    </message>
    <message>
        <source>The same colours for the same values in several figures; otherwise they follow from what is shown</source>
        <translation>कई चित्रों में समान मानों के लिए समान रंग; नहीं तो वे दिखाए गए से निकलते हैं</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>रंग यहाँ से</translation>
    </message>
    <message>
        <source>Value at the colours&apos; lower end</source>
        <translation>रंगों के निचले छोर का मान</translation>
    </message>
    <message>
        <source>Colours to</source>
        <translation>रंग यहाँ तक</translation>
    </message>
    <message>
        <source>Value at the colours&apos; upper end</source>
        <translation>रंगों के ऊपरी छोर का मान</translation>
    </message>
    <message>
        <source>Its colours are the scan&apos;s own</source>
        <translation>इसके रंग स्कैन के अपने हैं</translation>
    </message>
    <message>
        <source>Turn on &quot;Own ends of the colours&quot; first</source>
        <translation>पहले “रंगों के अपने छोर” चालू करें</translation>
    </message>
    <message>
        <source>No lamp shines on this relief</source>
        <translation>इस उभार पर कोई प्रकाश नहीं पड़ता</translation>
    </message>
    <message>
        <source>The four lights come from all sides</source>
        <translation>चारों प्रकाश सब ओर से आते हैं</translation>
    </message>
    <message>
        <source>This relief does not depend on one</source>
        <translation>यह उभार त्रिज्या पर निर्भर नहीं है</translation>
    </message>
    <message>
        <source>Only natural colours and intensity are mixed with it</source>
        <translation>केवल प्राकृतिक रंग और तीव्रता इसके साथ मिलाए जाते हैं</translation>
    </message>
    <message>
        <source>Detail alone</source>
        <translation>केवल विवरण</translation>
    </message>
    <message>
        <source>Whole object and detail</source>
        <translation>पूरी वस्तु और विवरण</translation>
    </message>
    <message>
        <source>As measured and filled</source>
        <translation>जैसा मापा और भरा हुआ</translation>
    </message>
    <message>
        <source>Several levels</source>
        <translation>कई स्तर</translation>
    </message>
    <message>
        <source>With force plots of a recording</source>
        <translation>रिकॉर्डिंग के बल आलेखों के साथ</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>फ़ाइल (&amp;F)</translation>
    </message>
    <message>
        <source>Ends in .png, .tif, .pdf or .svg</source>
        <translation>.png, .tif, .pdf या .svg पर समाप्त होता है</translation>
    </message>
    <message>
        <source>Save figure</source>
        <translation>चित्र सहेजें</translation>
    </message>
    <message>
        <source>Figures (*.png *.tif *.pdf *.svg)</source>
        <translation>चित्र (*.png *.tif *.pdf *.svg)</translation>
    </message>
    <message>
        <source>&amp;Layout</source>
        <translation>विन्यास (&amp;L)</translation>
    </message>
    <message>
        <source>What stands beside what</source>
        <translation>किसके पास क्या है</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>रिकॉर्डिंग (&amp;R)</translation>
    </message>
    <message>
        <source>File of a recording, CSV or HDF5, for the plots</source>
        <translation>आलेखों के लिए रिकॉर्डिंग की फ़ाइल, CSV या HDF5</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>रिकॉर्डिंग</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.h5 *.hdf5)</source>
        <translation>रिकॉर्डिंग (*.csv *.h5 *.hdf5)</translation>
    </message>
    <message>
        <source>Wi&amp;dth on paper</source>
        <translation>काग़ज़ पर चौड़ाई (&amp;D)</translation>
    </message>
    <message>
        <source>Journals have columns of 85 and pages of 180 mm</source>
        <translation>पत्रिकाओं में 85 के स्तंभ और 180 mm के पृष्ठ होते हैं</translation>
    </message>
    <message>
        <source>To &amp;scale</source>
        <translation>पैमाने पर (&amp;S)</translation>
    </message>
    <message>
        <source>Choose the scale of the detail; the width follows from it</source>
        <translation>विवरण का पैमाना चुनें; चौड़ाई उससे निकलती है</translation>
    </message>
    <message>
        <source>Scale &amp;1 :</source>
        <translation>पैमाना 1 (&amp;1) :</translation>
    </message>
    <message>
        <source>Millimetres of object on one millimetre of paper</source>
        <translation>काग़ज़ के एक मिलीमीटर पर वस्तु के मिलीमीटर</translation>
    </message>
    <message>
        <source>D&amp;ensity</source>
        <translation>घनत्व (&amp;E)</translation>
    </message>
    <message>
        <source>Dots per inch of paper</source>
        <translation>काग़ज़ के प्रति इंच बिंदु</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>&amp;Text size</source>
        <translation>पाठ का आकार (&amp;T)</translation>
    </message>
    <message>
        <source>Text and bars on paper, in points</source>
        <translation>काग़ज़ पर पाठ और पट्टियाँ, पॉइंट में</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Turn on &quot;To scale&quot; first</source>
        <translation>पहले “पैमाने पर” चालू करें</translation>
    </message>
    <message>
        <source>It follows from the scale</source>
        <translation>वह पैमाने से निकलती है</translation>
    </message>
    <message>
        <source>Only the layout with force plots shows one</source>
        <translation>केवल बल आलेखों वाला विन्यास इसे दिखाता है</translation>
    </message>
    <message>
        <source>Scale &amp;bar</source>
        <translation>पैमाना पट्टी (&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Height bar</source>
        <translation>ऊँचाई पट्टी (&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Up mark</source>
        <translation>ऊपर का चिह्न (&amp;U)</translation>
    </message>
    <message>
        <source>Window&apos;s &amp;outline</source>
        <translation>विंडो की रूपरेखा (&amp;O)</translation>
    </message>
    <message>
        <source>Hat&amp;ch</source>
        <translation>रेखा-छाया (&amp;C)</translation>
    </message>
    <message>
        <source>Le&amp;gend</source>
        <translation>संकेत सूची (&amp;G)</translation>
    </message>
    <message>
        <source>Letters a, b</source>
        <translation>अक्षर a, b</translation>
    </message>
    <message>
        <source>&amp;Measurements</source>
        <translation>माप (&amp;M)</translation>
    </message>
    <message>
        <source>Drawn in points, whatever the density</source>
        <translation>पॉइंट में बना, घनत्व जो भी हो</translation>
    </message>
    <message>
        <source>Tra&amp;nsparent paper</source>
        <translation>पारदर्शी काग़ज़ (&amp;N)</translation>
    </message>
    <message>
        <source>No white behind the relief</source>
        <translation>उभार के पीछे सफ़ेद नहीं</translation>
    </message>
    <message>
        <source>It is drawn on the whole object, which this layout lacks</source>
        <translation>यह पूरी वस्तु पर बनती है, जो इस विन्यास में नहीं है</translation>
    </message>
    <message>
        <source>An anaglyph needs its background</source>
        <translation>एनाग्लिफ़ को अपनी पृष्ठभूमि चाहिए</translation>
    </message>
    <message>
        <source>Both eyes &amp;as files</source>
        <translation>दोनों आँखें फ़ाइलों में (&amp;A)</translation>
    </message>
    <message>
        <source>Also write the detail as each eye sees it, as NAME.left.png and NAME.right.png beside the figure</source>
        <translation>विवरण जैसा हर आँख को दिखता है वैसा भी लिखें, चित्र के पास NAME.left.png और NAME.right.png में</translation>
    </message>
    <message>
        <source>Sa&amp;ve heights too</source>
        <translation>ऊँचाइयाँ भी सहेजें (&amp;V)</translation>
    </message>
    <message>
        <source>Also write the detail&apos;s heights as a picture of 16 bits; its description says millimetres per step</source>
        <translation>विवरण की ऊँचाइयाँ 16 बिट की तस्वीर में भी लिखें; उसका वर्णन प्रति चरण मिलीमीटर बताता है</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>ऊँचाइयाँ</translation>
    </message>
    <message>
        <source>Ends in .tif</source>
        <translation>.tif पर समाप्त होता है</translation>
    </message>
    <message>
        <source>Save heights</source>
        <translation>ऊँचाइयाँ सहेजें</translation>
    </message>
    <message>
        <source>Heights of 16 bits (*.tif *.tiff)</source>
        <translation>16 बिट की ऊँचाइयाँ (*.tif *.tiff)</translation>
    </message>
    <message>
        <source>Save caption as te&amp;xt</source>
        <translation>शीर्षक को पाठ में सहेजें (&amp;X)</translation>
    </message>
    <message>
        <source>Also write the caption as a text file</source>
        <translation>चित्र-शीर्षक को पाठ फ़ाइल में भी लिखें</translation>
    </message>
    <message>
        <source>Caption&apos;s file</source>
        <translation>शीर्षक की फ़ाइल</translation>
    </message>
    <message>
        <source>Where the caption is written</source>
        <translation>चित्र-शीर्षक कहाँ लिखा जाए</translation>
    </message>
    <message>
        <source>Save caption</source>
        <translation>चित्र-शीर्षक सहेजें</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>पाठ (*.txt)</translation>
    </message>
    <message>
        <source>Turn on &quot;Save heights too&quot; first</source>
        <translation>पहले “ऊँचाइयाँ भी सहेजें” चालू करें</translation>
    </message>
    <message>
        <source>Turn on &quot;Save caption as text&quot; first</source>
        <translation>पहले “शीर्षक को पाठ में सहेजें” चालू करें</translation>
    </message>
    <message>
        <source>None</source>
        <translation>कोई नहीं</translation>
    </message>
    <message>
        <source>Anaglyph, grey</source>
        <translation>एनाग्लिफ़, धूसर</translation>
    </message>
    <message>
        <source>Anaglyph, half colour</source>
        <translation>एनाग्लिफ़, अर्ध-रंग</translation>
    </message>
    <message>
        <source>Anaglyph, Dubois</source>
        <translation>एनाग्लिफ़, Dubois</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>साथ-साथ</translation>
    </message>
    <message>
        <source>One over the other</source>
        <translation>एक के ऊपर एक</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>स्टीरियो</translation>
    </message>
    <message>
        <source>For red and cyan glasses, or two pictures</source>
        <translation>लाल-सियान चश्मे के लिए, या दो चित्र</translation>
    </message>
    <message>
        <source>Eyes apart</source>
        <translation>आँखों की दूरी</translation>
    </message>
    <message>
        <source>Angle between the two eyes&apos; directions</source>
        <translation>दोनों आँखों की दिशाओं के बीच का कोण</translation>
    </message>
    <message>
        <source>&amp;Keep to 1° of parallax</source>
        <translation>लंबन 1° तक रखें (&amp;K)</translation>
    </message>
    <message>
        <source>Less angle where many readers would see double</source>
        <translation>जहाँ कई पाठक दोहरा देखेंगे वहाँ कम कोण</translation>
    </message>
    <message>
        <source>Own &amp;zero plane</source>
        <translation>अपना शून्य तल (&amp;Z)</translation>
    </message>
    <message>
        <source>Choose the height that lies in the plane of the paper; otherwise it is mid height</source>
        <translation>वह ऊँचाई चुनें जो काग़ज़ के तल में हो; नहीं तो वह बीच की ऊँचाई है</translation>
    </message>
    <message>
        <source>Zero plane</source>
        <translation>शून्य तल</translation>
    </message>
    <message>
        <source>Height of zero parallax: what is higher stands out of the paper, what is lower lies behind it</source>
        <translation>शून्य लंबन की ऊँचाई: जो ऊँचा है वह काग़ज़ से बाहर उभरता है, जो नीचा है वह पीछे रहता है</translation>
    </message>
    <message>
        <source>Swap eyes</source>
        <translation>आँखें बदलें</translation>
    </message>
    <message>
        <source>For glasses the other way round, or for crossed eyes</source>
        <translation>उलटे चश्मे या तिरछी आँखों के लिए</translation>
    </message>
    <message>
        <source>Choose a kind of stereo, or both eyes as files</source>
        <translation>स्टीरियो का कोई प्रकार चुनें, या दोनों आँखें फ़ाइलों में</translation>
    </message>
    <message>
        <source>Turn on &quot;Own zero plane&quot; first</source>
        <translation>पहले “अपना शून्य तल” चालू करें</translation>
    </message>
    <message>
        <source>Shaded, with ambient occlusion</source>
        <translation>छायांकित, परिवेशी अवरोधन के साथ</translation>
    </message>
    <message>
        <source>Shaded reliefs and hillshades have no colours</source>
        <translation>छायांकित उभारों और पहाड़ी छायाओं में रंग नहीं होते</translation>
    </message>
</context>
<context>
    <name>relievo::FirmnessRow</name>
    <message>
        <source>Choose…</source>
        <translation>चुनें…</translation>
    </message>
    <message>
        <source>No&amp;ne</source>
        <translation>कोई नहीं (&amp;N)</translation>
    </message>
    <message>
        <source>Stiffness &amp;map</source>
        <translation>कठोरता मानचित्र (&amp;M)</translation>
    </message>
    <message>
        <source>Stiffness map</source>
        <translation>कठोरता मानचित्र</translation>
    </message>
    <message>
        <source>Rasters (*.tif *.tiff *.asc *.png);;All files (*)</source>
        <translation>ग्रिड (*.tif *.tiff *.asc *.png);;सभी फ़ाइलें (*)</translation>
    </message>
    <message>
        <source>where it was measured</source>
        <translation>जहाँ मापा गया</translation>
    </message>
    <message>
        <source>%1 (not of this map)</source>
        <translation>%1 (इस मानचित्र का नहीं)</translation>
    </message>
    <message>
        <source>Stiffness map in use</source>
        <translation>उपयोग में कठोरता मानचित्र</translation>
    </message>
    <message>
        <source>Choose a stiffness map</source>
        <translation>कठोरता मानचित्र चुनें</translation>
    </message>
    <message>
        <source>A raster over the whole map: 1 where the surface is stiff, 0 where it is as soft as set above. In place of where it was measured.</source>
        <translation>पूरे मानचित्र पर ग्रिड: जहाँ सतह कठोर है वहाँ 1, जहाँ ऊपर तय की गई जितनी नरम है वहाँ 0। मापी जगह के बदले।</translation>
    </message>
    <message>
        <source>No stiffness map: stiff where it was measured</source>
        <translation>कठोरता मानचित्र नहीं: जहाँ मापा गया वहाँ कठोर</translation>
    </message>
    <message>
        <source>The surface is stiff where it was measured.</source>
        <translation>जहाँ मापा गया वहाँ सतह कठोर है।</translation>
    </message>
</context>
<context>
    <name>relievo::FirstViewCard</name>
    <message>
        <source>First view of the file that is being read</source>
        <translation>पढ़ी जा रही फ़ाइल का पहला दृश्य</translation>
    </message>
    <message>
        <source>%1: first view from %2 of %3 points. The whole is being read.</source>
        <translation>%1: %3 में से %2 बिंदुओं से पहला दृश्य। पूरी फ़ाइल पढ़ी जा रही है।</translation>
    </message>
    <message>
        <source>Until then the views and the hand stay with the object before.</source>
        <translation>तब तक दृश्य और हाथ पिछली वस्तु पर ही रहेंगे।</translation>
    </message>
    <message>
        <source>It can be touched then.</source>
        <translation>तब इसे छुआ जा सकेगा।</translation>
    </message>
</context>
<context>
    <name>relievo::ForceReturn</name>
    <message>
        <source>The device can push again. Lift the hand and press F5, or hold its button Centre: the forces rise from zero.</source>
        <translation>उपकरण फिर बल दे सकता है। हाथ उठाएँ और F5 दबाएँ, या उसका बटन बीच दबाए रखें: बल शून्य से बढ़ते हैं।</translation>
    </message>
    <message>
        <source>Lift the hand and press F5: the device is opened anew, and its forces rise from zero.</source>
        <translation>हाथ उठाएँ और F5 दबाएँ: उपकरण नए सिरे से खुलता है, और उसके बल शून्य से बढ़ते हैं।</translation>
    </message>
    <message>
        <source>Shift+F5 opens the chosen device again and takes its forces back.</source>
        <translation>Shift+F5 चुने हुए उपकरण को फिर खोलता है और उसके बल वापस लेता है।</translation>
    </message>
</context>
<context>
    <name>relievo::ForeignFiles</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>और %n अन्य</numerusform>
            <numerusform>और %n अन्य</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>रद्द किया गया। कुछ नहीं बदला।</translation>
    </message>
    <message>
        <source>Files elsewhere</source>
        <translation>अन्यत्र की फ़ाइलें</translation>
    </message>
    <message numerus="yes">
        <source>%1 names %n file(s) outside of its folder that are not, by their checksums, what it was made from:</source>
        <translation>
            <numerusform>%1 अपने फ़ोल्डर से बाहर की %n फ़ाइल का नाम लेता है, जो अपने चेकसम के अनुसार वह नहीं है जिससे यह बना था:</numerusform>
            <numerusform>%1 अपने फ़ोल्डर से बाहर की %n फ़ाइलों के नाम लेता है, जो अपने चेकसम के अनुसार वे नहीं हैं जिनसे यह बना था:</numerusform>
        </translation>
    </message>
    <message>
        <source>The work that was kept</source>
        <translation>रखा गया काम</translation>
    </message>
    <message>
        <source>Whoever made it chose these names. Shall they be read? What is not read stays named in it, and all else opens.</source>
        <translation>जिसने इसे बनाया, उसी ने ये नाम चुने। क्या इन्हें पढ़ा जाए? जो नहीं पढ़ा जाता, उसका नाम इसमें बना रहता है, और बाकी सब खुलता है।</translation>
    </message>
    <message>
        <source>&amp;Read them</source>
        <translation>&amp;पढ़ें</translation>
    </message>
    <message>
        <source>&amp;Do not read them</source>
        <translation>&amp;न पढ़ें</translation>
    </message>
</context>
<context>
    <name>relievo::GlassesDialog</name>
    <message>
        <source>Test picture</source>
        <translation>जाँच चित्र</translation>
    </message>
    <message>
        <source>Left an L for the left eye alone, right an R for the right eye alone</source>
        <translation>बाईं ओर L केवल बाईं आँख के लिए, दाईं ओर R केवल दाईं आँख के लिए</translation>
    </message>
    <message>
        <source>L</source>
        <comment>left eye</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right eye</comment>
        <translation>R</translation>
    </message>
    <message>
        <source>Test glasses</source>
        <translation>चश्मा जाँचें</translation>
    </message>
    <message>
        <source>Put the glasses on and close your right eye: you should see only the L, bright on black. With the left eye closed only the R. If it is the other way round, turn on &quot;Swap eyes&quot;. What shines through faintly is a ghost; Dubois has the least.</source>
        <translation>चश्मा पहनें और दाईं आँख बंद करें: केवल L दिखना चाहिए, काले पर चमकीला। बाईं आँख बंद हो तो केवल R। उलटा हो तो “आँखें बदलें” चालू करें। जो हल्का-सा झलकता है वह छाया-चित्र है; Dubois में वह सबसे कम है।</translation>
    </message>
</context>
<context>
    <name>relievo::GuideControl</name>
    <message>
        <source>Guide along a recording</source>
        <translation>रिकॉर्डिंग के साथ ले चलना</translation>
    </message>
    <message>
        <source>Recordings and strokes (*.csv *.h5 *.hdf5)</source>
        <translation>रिकॉर्डिंग और हाथ के रास्ते (*.csv *.h5 *.hdf5)</translation>
    </message>
    <message>
        <source>A recording is running. The introduction lays shapes under the hand that are not of this relief. End the recording first.</source>
        <translation>रिकॉर्डिंग चल रही है। परिचय हाथ के नीचे ऐसे आकार रखता है जो इस उभार के नहीं हैं। पहले रिकॉर्डिंग समाप्त करें।</translation>
    </message>
    <message>
        <source>The introduction is not recorded. End it first.</source>
        <translation>परिचय रिकॉर्ड नहीं होता। पहले उसे समाप्त करें।</translation>
    </message>
</context>
<context>
    <name>relievo::HandDevice</name>
    <message>
        <source>The device %1 is being opened. The mouse is the hand meanwhile.</source>
        <translation>उपकरण %1 खोला जा रहा है। तब तक माउस हाथ है।</translation>
    </message>
    <message>
        <source>Device: %1.</source>
        <translation>उपकरण: %1।</translation>
    </message>
    <message>
        <source>%1 The mouse is the hand now.</source>
        <translation>%1 अब माउस ही हाथ है।</translation>
    </message>
    <message>
        <source>Motors: %1 % of what they can take for good; forces stay below %2 N.</source>
        <translation>मोटर: जितना वे लगातार सह सकती हैं उसका %1 %; बल %2 N से कम रहते हैं।</translation>
    </message>
    <message>
        <source>A Falcon was plugged in. Choose it in the panel Touch to use it.</source>
        <translation>एक Falcon जोड़ा गया। उपयोग के लिए स्पर्श पटल में उसे चुनें।</translation>
    </message>
</context>
<context>
    <name>relievo::HaplySetupDialog</name>
    <message>
        <source>Device set-up: Haply</source>
        <translation>उपकरण की तैयारी: Haply</translation>
    </message>
    <message>
        <source>State of the Haply device</source>
        <translation>Haply उपकरण की अवस्था</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service is being looked for.</source>
        <translation>Haply की Inverse Service खोजी जा रही है।</translation>
    </message>
    <message>
        <source>What the service told last</source>
        <translation>सेवा ने अंत में क्या बताया</translation>
    </message>
    <message>
        <source>Which Haply device</source>
        <translation>कौन-सा Haply उपकरण</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>उपकरण (&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>फिर कोशिश (&amp;T)</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>फिर कोशिश</translation>
    </message>
    <message>
        <source>After another program set the device up, or the service did not obey forces</source>
        <translation>जब दूसरे प्रोग्राम ने उपकरण तैयार किया हो, या सेवा ने बल का पालन न किया हो</translation>
    </message>
    <message>
        <source>&amp;Use this device</source>
        <translation>इस उपकरण का उपयोग करें (&amp;U)</translation>
    </message>
    <message>
        <source>Use this device</source>
        <translation>इस उपकरण का उपयोग करें</translation>
    </message>
    <message>
        <source>Set up a &amp;Falcon…</source>
        <translation>Falcon तैयार करें… (&amp;F)</translation>
    </message>
    <message>
        <source>Set up a Falcon</source>
        <translation>Falcon तैयार करें</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>बंद करें</translation>
    </message>
</context>
<context>
    <name>relievo::HaplySteps</name>
    <message>
        <source>Steps</source>
        <translation>चरण</translation>
    </message>
    <message>
        <source>Inverse Service runs</source>
        <translation>Inverse Service चल रही है</translation>
    </message>
    <message>
        <source>Device is plugged in</source>
        <translation>उपकरण जुड़ा है</translation>
    </message>
    <message>
        <source>Motors have power</source>
        <translation>मोटरों को बिजली मिलती है</translation>
    </message>
    <message>
        <source>Service has started it</source>
        <translation>सेवा ने उसे चालू किया है</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>अंशांकित</translation>
    </message>
    <message>
        <source>Set up for touching</source>
        <translation>स्पर्श के लिए तैयार</translation>
    </message>
    <message>
        <source>Place of the hand</source>
        <translation>हाथ का स्थान</translation>
    </message>
    <message>
        <source>Buttons that are pressed</source>
        <translation>दबे हुए बटन</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>हाथ</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>बटन</translation>
    </message>
    <message>
        <source>✓ done</source>
        <translation>✓ पूरा</translation>
    </message>
    <message>
        <source>– waits for this</source>
        <translation>– इसकी प्रतीक्षा है</translation>
    </message>
    <message>
        <source>– not known yet</source>
        <translation>– अभी ज्ञात नहीं</translation>
    </message>
    <message>
        <source>%1 right, %2 up, %3 out, in millimetres; %4 answers per second</source>
        <translation>दाएँ %1, ऊपर %2, बाहर %3, मिलीमीटर में; प्रति सेकंड %4 उत्तर</translation>
    </message>
    <message>
        <source>not known before the device is there</source>
        <translation>उपकरण के आने से पहले ज्ञात नहीं</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>प्लस</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>आगे</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>बीच</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>माइनस</translation>
    </message>
    <message>
        <source>none</source>
        <translation>कोई नहीं</translation>
    </message>
</context>
<context>
    <name>relievo::HapticsPanel</name>
    <message>
        <source>Off: %1. Switch off and on to try again.</source>
        <translation>बंद: %1। फिर कोशिश के लिए बंद करके चालू करें।</translation>
    </message>
    <message>
        <source>Off. Press F5 to switch forces on.</source>
        <translation>बंद। बल चालू करने के लिए F5 दबाएँ।</translation>
    </message>
    <message>
        <source>Waiting until the hand is clear of the surface.</source>
        <translation>हाथ के सतह से हटने की प्रतीक्षा।</translation>
    </message>
    <message>
        <source>Coming on.</source>
        <translation>चालू हो रहा है।</translation>
    </message>
    <message>
        <source>On, softened to %1 N/mm against swinging until switched off.</source>
        <translation>चालू, कंपन के विरुद्ध बंद करने तक %1 N/mm तक नरम।</translation>
    </message>
    <message>
        <source>On.</source>
        <translation>चालू।</translation>
    </message>
    <message>
        <source>On: computed and shown; a mouse cannot push back.</source>
        <translation>चालू: गणना और प्रदर्शन; माउस वापस नहीं धकेल सकता।</translation>
    </message>
    <message>
        <source>Forces &amp;on</source>
        <translation>बल चालू (&amp;O)</translation>
    </message>
    <message>
        <source>Forces on</source>
        <translation>बल चालू</translation>
    </message>
    <message>
        <source>Switch forces on or off (F5). Esc switches them off.</source>
        <translation>बल चालू या बंद करें (F5)। Esc बंद करता है।</translation>
    </message>
    <message>
        <source>State of the forces</source>
        <translation>बलों की अवस्था</translation>
    </message>
    <message>
        <source>On. E306: Update rate fell to %1 per second (need %2). Stiffness reduced from %3 to %4 N/m.</source>
        <translation>चालू। E306: अद्यतन दर %1 प्रति सेकंड रह गई (%2 चाहिए)। कठोरता %3 से घटाकर %4 N/m की गई।</translation>
    </message>
    <message>
        <source>A new surface under the hand</source>
        <translation>हाथ के नीचे नई सतह</translation>
    </message>
    <message>
        <source>The new surface comes under the hand: %1 %.</source>
        <translation>नई सतह हाथ के नीचे आ रही है: %1 %।</translation>
    </message>
    <message>
        <source>Off: %1. %2</source>
        <translation>बंद: %1। %2</translation>
    </message>
    <message>
        <source>Take the forces bac&amp;k</source>
        <translation>बल वापस लें (&amp;K)</translation>
    </message>
    <message>
        <source>Take the forces back</source>
        <translation>बल वापस लें</translation>
    </message>
    <message>
        <source>Opens the device again (Shift+F5). Its forces rise from zero once the hand is clear.</source>
        <translation>उपकरण को फिर खोलता है (Shift+F5)। हाथ के अलग होते ही उसके बल शून्य से बढ़ते हैं।</translation>
    </message>
</context>
<context>
    <name>relievo::HapticsPlugin</name>
    <message>
        <source>Touch</source>
        <translation>स्पर्श</translation>
    </message>
    <message>
        <source>Nothing to touch yet. Open a scan first.</source>
        <translation>छूने को अभी कुछ नहीं। पहले कोई स्कैन खोलें।</translation>
    </message>
    <message>
        <source>Forces on.</source>
        <translation>बल चालू।</translation>
    </message>
    <message>
        <source>Forces off.</source>
        <translation>बल बंद।</translation>
    </message>
    <message>
        <source>Strength %1 percent.</source>
        <translation>प्रबलता %1 प्रतिशत।</translation>
    </message>
    <message>
        <source>Forces are off after the sleep. Press F5 to switch them on.</source>
        <translation>नींद के बाद बल बंद हैं। चालू करने के लिए F5 दबाएँ।</translation>
    </message>
    <message>
        <source>Touch: advanced</source>
        <translation>स्पर्श: उन्नत</translation>
    </message>
    <message>
        <source>Strength: %1.</source>
        <translation>प्रबलता: %1।</translation>
    </message>
    <message>
        <source>Grip position: %1.</source>
        <translation>ग्रिप की स्थिति: %1।</translation>
    </message>
</context>
<context>
    <name>relievo::HeightHistogram</name>
    <message>
        <source>Heights of measured cells</source>
        <translation>मापे गए सेलों की ऊँचाइयाँ</translation>
    </message>
    <message>
        <source>From %1 to %2 mm</source>
        <translation>%1 से %2 mm तक</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>height</source>
        <translation>ऊँचाई</translation>
    </message>
</context>
<context>
    <name>relievo::HomingPicture</name>
    <message>
        <source>What to do with the grip</source>
        <translation>पकड़ के साथ क्या करना है</translation>
    </message>
    <message>
        <source>Push the grip all the way in. The light is red.</source>
        <translation>पकड़ को पूरा अंदर धकेलें। बत्ती लाल है।</translation>
    </message>
    <message>
        <source>Pull the grip all the way out. The light is blue.</source>
        <translation>पकड़ को पूरा बाहर खींचें। बत्ती नीली है।</translation>
    </message>
    <message>
        <source>The grip&apos;s place is known. The light is blue.</source>
        <translation>पकड़ की जगह मालूम है। बत्ती नीली है।</translation>
    </message>
    <message>
        <source>Nothing to do with the grip yet.</source>
        <translation>पकड़ के साथ अभी कुछ नहीं करना है।</translation>
    </message>
</context>
<context>
    <name>relievo::ImageDialog</name>
    <message>
        <source>Width</source>
        <translation>चौड़ाई</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>ऊँचाई</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>चित्र सहेजें</translation>
    </message>
    <message>
        <source>Picture of</source>
        <translation>किसका चित्र</translation>
    </message>
    <message>
        <source>What the picture shows</source>
        <translation>चित्र क्या दिखाता है</translation>
    </message>
    <message>
        <source>Detail view</source>
        <translation>विवरण दृश्य</translation>
    </message>
    <message>
        <source>Whole window</source>
        <translation>पूरी खिड़की</translation>
    </message>
    <message>
        <source>File</source>
        <translation>फ़ाइल</translation>
    </message>
    <message>
        <source>Where the picture is saved</source>
        <translation>चित्र कहाँ सहेजा जाए</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>ढूँढें (&amp;B)…</translation>
    </message>
    <message>
        <source>Browse</source>
        <translation>ढूँढें</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>दूसरी जगह चुनें</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG चित्र (*.png)</translation>
    </message>
    <message>
        <source>&amp;Picture of</source>
        <translation>किसका चित्र (&amp;P)</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>आकार (&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>फ़ाइल (&amp;F)</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>अवलोकन</translation>
    </message>
    <message>
        <source>Both &amp;eyes as files</source>
        <translation>दोनों आँखें फ़ाइलों में (&amp;E)</translation>
    </message>
    <message>
        <source>Also each eye&apos;s picture of the detail, as NAME.left.png and NAME.right.png</source>
        <translation>विवरण का हर आँख का चित्र भी, NAME.left.png और NAME.right.png नाम से</translation>
    </message>
</context>
<context>
    <name>relievo::KeysSheet</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Stop forces, then cancel, then leave the mode</source>
        <translation>पहले बल रोकें, फिर रद्द करें, फिर विधा छोड़ें</translation>
    </message>
    <message>
        <source>Detail view: arrows, Shift+arrows</source>
        <translation>विवरण दृश्य: तीर, Shift+तीर</translation>
    </message>
    <message>
        <source>Move the hand by 1 or by 10 cells</source>
        <translation>हाथ को 1 या 10 सेल चलाएँ</translation>
    </message>
    <message>
        <source>Detail view: Page Down, Page Up</source>
        <translation>विवरण दृश्य: Page Down, Page Up</translation>
    </message>
    <message>
        <source>Press in, lift</source>
        <translation>भीतर दबाएँ, उठाएँ</translation>
    </message>
    <message>
        <source>Detail view: left button</source>
        <translation>विवरण दृश्य: बायाँ बटन</translation>
    </message>
    <message>
        <source>Detail view: Ctrl+wheel</source>
        <translation>विवरण दृश्य: Ctrl+पहिया</translation>
    </message>
    <message>
        <source>Change the press depth</source>
        <translation>दबाने की गहराई बदलें</translation>
    </message>
    <message>
        <source>Detail view: wheel</source>
        <translation>विवरण दृश्य: पहिया</translation>
    </message>
    <message>
        <source>Draw, move or resize the window</source>
        <translation>विंडो बनाएँ, खिसकाएँ या आकार बदलें</translation>
    </message>
    <message>
        <source>Move, resize the window</source>
        <translation>विंडो खिसकाएँ, आकार बदलें</translation>
    </message>
    <message>
        <source>Draw a window</source>
        <translation>विंडो बनाएँ</translation>
    </message>
    <message>
        <source>Finer, coarser</source>
        <translation>बारीक, मोटा</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>कुंजियाँ</translation>
    </message>
    <message>
        <source>What they do</source>
        <translation>वे क्या करती हैं</translation>
    </message>
    <message>
        <source>Other commands</source>
        <translation>अन्य आदेश</translation>
    </message>
    <message>
        <source>In the views, by mouse and keys</source>
        <translation>दृश्यों में, माउस और कुंजियों से</translation>
    </message>
    <message>
        <source>Search keys</source>
        <translation>कुंजियाँ खोजें</translation>
    </message>
    <message>
        <source>Words of what a key does, or the key itself</source>
        <translation>कुंजी क्या करती है उसके शब्द, या स्वयं कुंजी</translation>
    </message>
    <message>
        <source>No key has these words. Ctrl+K finds commands without a key, too.</source>
        <translation>किसी कुंजी में ये शब्द नहीं। Ctrl+K बिना कुंजी के आदेश भी खोजता है।</translation>
    </message>
    <message>
        <source>Look: %1. Touch: %2</source>
        <translation>देखना: %1। स्पर्श: %2</translation>
    </message>
    <message>
        <source>press the hand in</source>
        <translation>हाथ भीतर दबाएँ</translation>
    </message>
    <message>
        <source>Detail view: middle button</source>
        <translation>विवरण दृश्य: बीच का बटन</translation>
    </message>
    <message>
        <source>Detail view: right button</source>
        <translation>विवरण दृश्य: दायाँ बटन</translation>
    </message>
    <message>
        <source>Zoom about the pointer; away from you is closer</source>
        <translation>सूचक के पास लाएँ; आपसे दूर घुमाना पास लाता है</translation>
    </message>
    <message>
        <source>Zoom about the pointer; towards you is closer</source>
        <translation>सूचक के पास लाएँ; आपकी ओर घुमाना पास लाता है</translation>
    </message>
    <message>
        <source>Overview: drag</source>
        <translation>अवलोकन: खींचना</translation>
    </message>
    <message>
        <source>Overview: arrows, Shift+arrows</source>
        <translation>अवलोकन: तीर, Shift+तीर</translation>
    </message>
    <message>
        <source>Overview: Space, arrows, Enter</source>
        <translation>अवलोकन: Space, तीर, Enter</translation>
    </message>
    <message>
        <source>Overview: +, −, wheel</source>
        <translation>अवलोकन: +, −, पहिया</translation>
    </message>
</context>
<context>
    <name>relievo::LightBall</name>
    <message>
        <source>Light</source>
        <translation>प्रकाश</translation>
    </message>
    <message>
        <source>Drag to move the light: the rim is raking light, the middle is light from you. Arrows move it by 5 degrees</source>
        <translation>खींचने से प्रकाश हिलता है: किनारे पर तिरछा प्रकाश, बीच में आपकी ओर से प्रकाश। तीर उसे 5 अंश हिलाते हैं</translation>
    </message>
    <message>
        <source>Light from %1°, %2° high</source>
        <translation>प्रकाश %1° से, %2° ऊँचा</translation>
    </message>
</context>
<context>
    <name>relievo::LookController</name>
    <message>
        <source>Light</source>
        <translation>प्रकाश</translation>
    </message>
    <message>
        <source>Shading of colours</source>
        <translation>रंगों का छायांकन</translation>
    </message>
    <message>
        <source>Relief image</source>
        <translation>उभार चित्र</translation>
    </message>
    <message>
        <source>Unmeasured cells</source>
        <translation>बिना मापी कोशिकाएँ</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>स्टीरियो</translation>
    </message>
    <message>
        <source>%1. This relief image has no lamp: the light shows in others.</source>
        <translation>%1। इस उभार चित्र में कोई दीपक नहीं: प्रकाश दूसरों में दिखता है।</translation>
    </message>
    <message>
        <source>%1 % of this picture is a strong red or cyan, which one eye sees dark through the glasses. Grey stereo shows it to both</source>
        <translation>इस चित्र का %1 % गहरा लाल या सियान है, जो चश्मे से एक आँख को काला दिखता है। धूसर स्टीरियो दोनों को दिखाता है</translation>
    </message>
    <message>
        <source>This scan has no colours; it is shown as shaded relief</source>
        <translation>इस स्कैन में रंग नहीं हैं; यह छायांकित उभार के रूप में दिखता है</translation>
    </message>
    <message>
        <source>This scan has no intensities; it is shown as shaded relief</source>
        <translation>इस स्कैन में तीव्रताएँ नहीं हैं; यह छायांकित उभार के रूप में दिखता है</translation>
    </message>
</context>
<context>
    <name>relievo::LoopAnnouncer</name>
    <message>
        <source>Forces off: %1.</source>
        <translation>बल बंद: %1।</translation>
    </message>
    <message>
        <source>Forces went off, because the window did not answer for %1 s. Press F5 to switch them on.</source>
        <translation>बल बंद हो गए, क्योंकि विंडो ने %1 से. तक उत्तर नहीं दिया। चालू करने के लिए F5 दबाएँ।</translation>
    </message>
    <message>
        <source>The hand pushes over the edge of the window.</source>
        <translation>हाथ विंडो के किनारे से बाहर धकेल रहा है।</translation>
    </message>
    <message>
        <source>The hand is clear: forces come on.</source>
        <translation>हाथ सतह से अलग है: बल चालू हो रहे हैं।</translation>
    </message>
    <message>
        <source>Forces wait: the hand is inside. Let go or press Page Up.</source>
        <translation>बल रुके हैं: हाथ सतह के भीतर है। बटन छोड़ें या Page Up दबाएँ।</translation>
    </message>
    <message>
        <source>Forces wait: the hand is inside. Raise the grip.</source>
        <translation>बल रुके हैं: हाथ सतह के भीतर है। हत्था ऊपर उठाएँ।</translation>
    </message>
    <message>
        <source>Softened to %1 N/mm: hand and surface had begun to swing.</source>
        <translation>%1 N/mm तक नरम किया: हाथ और सतह काँपने लगे थे।</translation>
    </message>
    <message>
        <source>Surface made softer to stay steady.</source>
        <translation>सतह स्थिर रखने के लिए नरम की गई।</translation>
    </message>
</context>
<context>
    <name>relievo::LoopDetailsDialog</name>
    <message>
        <source>How the force loop runs</source>
        <translation>बल चक्र कैसे चल रहा है</translation>
    </message>
    <message>
        <source>Counts of the force loop since it began</source>
        <translation>आरंभ से बल चक्र की गिनती</translation>
    </message>
</context>
<context>
    <name>relievo::LoopRows</name>
    <message>
        <source>How far the hand is pressed in</source>
        <translation>हाथ कितना भीतर दबा है</translation>
    </message>
    <message>
        <source>How the force loop runs</source>
        <translation>बल चक्र कैसे चल रहा है</translation>
    </message>
    <message>
        <source>More a&amp;bout the loop…</source>
        <translation>चक्र के बारे में और (&amp;B)…</translation>
    </message>
    <message>
        <source>More about the force loop</source>
        <translation>बल चक्र के बारे में और</translation>
    </message>
    <message>
        <source>Plots &amp;with a cursor…</source>
        <translation>सूचक वाले आलेख (&amp;W)…</translation>
    </message>
    <message>
        <source>Plots of height and force with a cursor</source>
        <translation>सूचक के साथ ऊँचाई और बल के आलेख</translation>
    </message>
    <message>
        <source>Pause, zoom, read values, and save as SVG or CSV.</source>
        <translation>रोकें, पास लाएँ, मान पढ़ें और SVG या CSV में सहेजें।</translation>
    </message>
    <message>
        <source>Wake-ups and computing times as tables, and what the system granted.</source>
        <translation>जागने और गणना के समय की तालिकाएँ, और प्रणाली ने क्या दिया।</translation>
    </message>
    <message>
        <source>Pressed in</source>
        <translation>दबा हुआ</translation>
    </message>
    <message>
        <source>Force loop</source>
        <translation>बल चक्र</translation>
    </message>
    <message>
        <source>%1 mm of hand</source>
        <translation>हाथ के %1 mm</translation>
    </message>
    <message>
        <source>not touching</source>
        <translation>स्पर्श नहीं</translation>
    </message>
</context>
<context>
    <name>relievo::MainWindow</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>हाल की फ़ाइलें (&amp;R)</translation>
    </message>
    <message>
        <source>Files opened before</source>
        <translation>पहले खोली गई फ़ाइलें</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>औज़ार</translation>
    </message>
    <message>
        <source>View</source>
        <translation>दृश्य</translation>
    </message>
    <message>
        <source>From which side the object is seen (Alt+1 to Alt+6)</source>
        <translation>वस्तु किस ओर से देखी जाती है (Alt+1 से Alt+6)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>यह सूची खाली करें (&amp;C)</translation>
    </message>
    <message>
        <source>Forget these files</source>
        <translation>ये फ़ाइलें भूल जाएँ</translation>
    </message>
    <message>
        <source>About relievo</source>
        <translation>relievo के बारे में</translation>
    </message>
    <message>
        <source>&lt;b&gt;relievo %1&lt;/b&gt;&lt;br&gt;See and touch scans of reliefs: a depth map, its pyramid, and a window on it that is shown in stereo and felt.&lt;br&gt;&lt;br&gt;BSD-3-Clause licence.</source>
        <translation>&lt;b&gt;relievo %1&lt;/b&gt;&lt;br&gt;उभारों के स्कैन देखें और छुएँ: गहराई मानचित्र, उसका पिरामिड, और उस पर एक विंडो जो स्टीरियो में दिखती और महसूस होती है।&lt;br&gt;&lt;br&gt;BSD-3-Clause लाइसेंस।</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>रद्द किया गया। कुछ नहीं बदला।</translation>
    </message>
    <message>
        <source>%1: %2, points: %3</source>
        <translation>%1: %2, बिंदु: %3</translation>
    </message>
    <message>
        <source>%1 is open.</source>
        <translation>%1 खुली है।</translation>
    </message>
    <message>
        <source>%1 Press F5 to switch forces on.</source>
        <translation>%1 बल चालू करने के लिए F5 दबाएँ।</translation>
    </message>
    <message>
        <source>the haptics plugin was not found.</source>
        <translation>हैप्टिक प्लगइन नहीं मिला।</translation>
    </message>
    <message>
        <source>Level 0 of the pyramid: not smoothed</source>
        <translation>पिरामिड का स्तर 0: चिकना नहीं किया गया</translation>
    </message>
    <message>
        <source>Level %1 of the pyramid, smoothed by a Gaussian of σ = %2</source>
        <translation>पिरामिड का स्तर %1, σ = %2 के गाउसीय से चिकना किया गया</translation>
    </message>
    <message>
        <source>%1 is closed</source>
        <translation>%1 बंद है</translation>
    </message>
    <message>
        <source>%1 is closed when the recording is saved</source>
        <translation>रिकॉर्डिंग सहेजी जाने पर %1 बंद होगा</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1। %2</translation>
    </message>
    <message>
        <source>%1 stays open</source>
        <translation>%1 खुला रहता है</translation>
    </message>
    <message>
        <source>The scan in 3-D: arrows turn it, Enter makes the relief from there</source>
        <translation>3-D में स्कैन: तीर उसे घुमाते हैं, Enter वहाँ से उभार बनाता है</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>अवलोकन</translation>
    </message>
    <message>
        <source>Resolution %1 of %2</source>
        <translation>रिज़ॉल्यूशन %2 में से %1</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>रिज़ॉल्यूशन</translation>
    </message>
    <message>
        <source>Which level of the pyramid feeds the window</source>
        <translation>विंडो में पिरामिड का कौन-सा स्तर है</translation>
    </message>
    <message>
        <source>Resolution %1/%2</source>
        <translation>रिज़ॉल्यूशन %1/%2</translation>
    </message>
    <message>
        <source>Only files on this computer, or one address of a published map, can be opened. Nothing was opened.</source>
        <translation>केवल इस कंप्यूटर की फ़ाइलें, या प्रकाशित मानचित्र का एक ही पता, खोला जा सकता है। कुछ नहीं खोला गया।</translation>
    </message>
    <message>
        <source>Resolution %1/%2, %3 on its way</source>
        <translation>रिज़ॉल्यूशन %1/%2, %3 आ रहा है</translation>
    </message>
</context>
<context>
    <name>relievo::Manual</name>
    <message>
        <source>The manual is not here. The package relievo brings it, unless the system leaves out what belongs in /usr/share/doc; in the sources &quot;cmake --build --preset release --target site&quot; makes it, and docs/user has the same as text.</source>
        <translation>पुस्तिका यहाँ नहीं है। पैकेज relievo उसे लाता है, जब तक तंत्र /usr/share/doc की चीज़ें छोड़ न दे; स्रोतों में &quot;cmake --build --preset release --target site&quot; उसे बनाता है, और docs/user में वही पाठ के रूप में है।</translation>
    </message>
    <message>
        <source>No browser could be started. Install one, or open this file elsewhere: %1</source>
        <translation>कोई ब्राउज़र शुरू नहीं हो सका। एक स्थापित करें, या यह फ़ाइल कहीं और खोलें: %1</translation>
    </message>
    <message>
        <source>The manual opens in the browser: %1</source>
        <translation>पुस्तिका ब्राउज़र में खुलती है: %1</translation>
    </message>
</context>
<context>
    <name>relievo::MeasureController</name>
    <message>
        <source>Save measurements</source>
        <translation>माप सहेजें</translation>
    </message>
    <message>
        <source>List of measurements (*.csv)</source>
        <translation>मापों की सूची (*.csv)</translation>
    </message>
    <message>
        <source>Selected profile or section (*.csv *.svg)</source>
        <translation>चुना प्रोफ़ाइल या काट (*.csv *.svg)</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 सहेजी गई</translation>
    </message>
    <message>
        <source>Save profile</source>
        <translation>प्रोफ़ाइल सहेजें</translation>
    </message>
    <message>
        <source>As it is shown (*.svg)</source>
        <translation>जैसी दिखती है (*.svg)</translation>
    </message>
    <message>
        <source>Its numbers (*.csv)</source>
        <translation>उसकी संख्याएँ (*.csv)</translation>
    </message>
</context>
<context>
    <name>relievo::MeasurePanel</name>
    <message>
        <source>Point</source>
        <translation>बिंदु</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>दूरी</translation>
    </message>
    <message>
        <source>Depth difference</source>
        <translation>गहराई का अंतर</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>कोण</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>प्रोफ़ाइल</translation>
    </message>
    <message>
        <source>Area and volume</source>
        <translation>क्षेत्रफल और आयतन</translation>
    </message>
    <message>
        <source>%1 %2 ± %3 %4</source>
        <translation>%1 %2 ± %3 %4</translation>
    </message>
    <message>
        <source>%1 % of it is not measured</source>
        <translation>इसका %1 % मापा नहीं गया</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>हटाएँ</translation>
    </message>
    <message>
        <source>Save list…</source>
        <translation>सूची सहेजें…</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>आगे क्या करना है</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>माप</translation>
    </message>
    <message>
        <source>Names can be changed by a double click or F2</source>
        <translation>नाम दोहरे क्लिक या F2 से बदलते हैं</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>नाम</translation>
    </message>
    <message>
        <source>Reads</source>
        <translation>मान</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>सब चुनें</translation>
    </message>
    <message>
        <source>Delete the selected measurement</source>
        <translation>चुना हुआ माप हटाएँ</translation>
    </message>
    <message>
        <source>There is no surface here</source>
        <translation>यहाँ कोई सतह नहीं है</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>Choose in the Measure menu.</source>
        <translation>मापन मेनू में से चुनें।</translation>
    </message>
    <message>
        <source>%1: place %2 of %3. Click on the detail view, or move the hand there and press Enter.</source>
        <translation>%1: जगह %3 में से %2। विवरण दृश्य पर क्लिक करें, या हाथ वहाँ ले जाकर Enter दबाएँ।</translation>
    </message>
    <message>
        <source>A double click or F ends.</source>
        <translation>दोहरा क्लिक या F समाप्त करता है।</translation>
    </message>
    <message>
        <source>By touch: with forces on (F5), tap two places for their depth difference, or draw a stroke for a profile. Escape ends.</source>
        <translation>स्पर्श से: बल चालू रखकर (F5) दो जगह टैप करें, गहराई का अंतर मिलेगा; या रेखा खींचें, प्रोफ़ाइल मिलेगी। Escape समाप्त करता है।</translation>
    </message>
    <message>
        <source>Being read…</source>
        <translation>पढ़ा जा रहा है…</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>काट</translation>
    </message>
    <message>
        <source>Plane level at %1 mm</source>
        <translation>समतल क्षैतिज, %1 mm पर</translation>
    </message>
    <message>
        <source>Plane upright, %1 mm from the corner</source>
        <translation>समतल खड़ा, कोने से %1 mm</translation>
    </message>
    <message>
        <source>Plane oblique, %1 mm from the corner</source>
        <translation>समतल तिरछा, कोने से %1 mm</translation>
    </message>
    <message>
        <source>Save the list as CSV, or the selected profile or section as CSV or SVG</source>
        <translation>सूची CSV में सहेजें, या चुना प्रोफ़ाइल या काट CSV या SVG में</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Volume counts from:</source>
        <translation>आयतन यहाँ से गिना जाता है:</translation>
    </message>
    <message>
        <source>Plane at:</source>
        <translation>समतल यहाँ:</translation>
    </message>
    <message>
        <source>Height from which the volume counts</source>
        <translation>ऊँचाई जहाँ से आयतन गिना जाता है</translation>
    </message>
    <message>
        <source>Place of the section&apos;s plane</source>
        <translation>काट के समतल की जगह</translation>
    </message>
    <message>
        <source>Height of the plane above which the volume of the selected area counts</source>
        <translation>उस समतल की ऊँचाई जिसके ऊपर चुने क्षेत्र का आयतन गिना जाता है</translation>
    </message>
    <message>
        <source>Distance of the section&apos;s plane from the lower left corner at height 0, along its normal; the height of a level plane</source>
        <translation>काट के समतल की निचले बाएँ कोने से ऊँचाई 0 पर, उसके अभिलंब की दिशा में दूरी; क्षैतिज समतल की ऊँचाई</translation>
    </message>
    <message numerus="yes">
        <source>%n curve(s)</source>
        <translation>
            <numerusform>%n वक्र</numerusform>
            <numerusform>%n वक्र</numerusform>
        </translation>
    </message>
    <message>
        <source>The outline would cross itself here. Choose another place.</source>
        <translation>यहाँ रूपरेखा स्वयं को काटेगी। दूसरी जगह चुनें।</translation>
    </message>
    <message>
        <source>The outline crosses itself or has no area. Its last corner was taken back.</source>
        <translation>रूपरेखा स्वयं को काटती है या उसका कोई क्षेत्र नहीं है। उसका आख़िरी कोना वापस लिया गया।</translation>
    </message>
    <message>
        <source>F after one place: the contour at its height; after two: an upright cut through both. Three places: the plane through them.</source>
        <translation>एक जगह के बाद F: उसकी ऊँचाई की समोच्च रेखा; दो के बाद: दोनों से होकर खड़ी काट। तीन जगहें: उनसे होकर समतल।</translation>
    </message>
    <message>
        <source>The finest resolution of this place is on its way. Choose the place again in a moment.</source>
        <translation>इस जगह का सबसे बारीक रिज़ॉल्यूशन आ रहा है। थोड़ी देर में यह जगह फिर चुनें।</translation>
    </message>
</context>
<context>
    <name>relievo::Message</name>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>रद्द किया गया। कुछ नहीं बदला गया।</translation>
    </message>
    <message>
        <source>what has this name is no regular file</source>
        <translation>इस नाम की चीज़ सामान्य फ़ाइल नहीं है</translation>
    </message>
    <message>
        <source>it is read-only</source>
        <translation>यह केवल पढ़ने के लिए है</translation>
    </message>
    <message>
        <source>its symbolic links lead in a circle</source>
        <translation>इसके प्रतीकात्मक लिंक चक्र में जाते हैं</translation>
    </message>
    <message>
        <source>Cannot write %1: %2. It was left as it is. Choose another name.</source>
        <translation>%1 लिखी नहीं जा सकती: %2। उसे वैसा ही छोड़ा गया। दूसरा नाम चुनें।</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is the scan itself. Nothing was written. Choose another name.</source>
        <translation>आउटपुट &apos;%1&apos; स्वयं स्कैन है। कुछ नहीं लिखा गया। दूसरा नाम चुनें।</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is %2. Nothing was written. Choose another name.</source>
        <translation>आउटपुट &apos;%1&apos; एक इनपुट भी है (%2)। कुछ नहीं लिखा गया। दूसरा नाम चुनें।</translation>
    </message>
    <message>
        <source>Two of the outputs would be &apos;%1&apos;. Nothing was written. Give one of them another name.</source>
        <translation>दो आउटपुट का नाम &apos;%1&apos; होगा। कुछ नहीं लिखा गया। उनमें से एक को दूसरा नाम दें।</translation>
    </message>
    <message>
        <source>Cannot write %1: %2. Check the folder, its permissions and the free space.</source>
        <translation>%1 लिखी नहीं जा सकती: %2। फ़ोल्डर, उसकी अनुमति और खाली जगह जाँचें।</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; cannot be read.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; पढ़ी नहीं जा सकती।</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; cannot be read to its end.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; अंत तक नहीं पढ़ी जा सकती।</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; cannot be read as a log of this version.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; इस संस्करण की रिकॉर्डिंग के रूप में पढ़ी नहीं जा सकती।</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; has a row that cannot be read: number %2.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; की एक पंक्ति पढ़ी नहीं जा सकती: क्रमांक %2।</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; has other columns than this version&apos;s: it has no &quot;%2&quot;.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; के स्तंभ इस संस्करण के स्तंभों से अलग हैं: इसमें &quot;%2&quot; नहीं है।</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; has no rows.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; में कोई पंक्ति नहीं है।</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; has columns of two lengths.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; के स्तंभ दो अलग लंबाइयों के हैं।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no recording of relievo. Choose a .csv or .h5 file that it recorded.</source>
        <translation>&quot;%1&quot; relievo की रिकॉर्डिंग नहीं है। उसकी रिकॉर्ड की हुई .csv या .h5 फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read as HDF5.</source>
        <translation>&quot;%1&quot; HDF5 के रूप में नहीं पढ़ी जा सकती।</translation>
    </message>
    <message>
        <source>HDF5 refused a part of the file.</source>
        <translation>HDF5 ने फ़ाइल का एक भाग अस्वीकार किया।</translation>
    </message>
    <message>
        <source>HDF5 could not write.</source>
        <translation>HDF5 लिख नहीं सका।</translation>
    </message>
    <message>
        <source>The folder %1 for automatic copies cannot be written (%2). Save by hand, or free some space.</source>
        <translation>अपने-आप बनने वाली प्रतियों का फ़ोल्डर %1 लिखा नहीं जा सकता (%2)। स्वयं सहेजें, या जगह खाली करें।</translation>
    </message>
    <message>
        <source>A figure&apos;s width in mm must be %1 to %2. Nothing was drawn.</source>
        <translation>चित्र की चौड़ाई (mm में) %1 से %2 तक होना चाहिए। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>A figure&apos;s dots per inch must be %1 to %2. Nothing was drawn.</source>
        <translation>चित्र के प्रति इंच बिंदु %1 से %2 तक होना चाहिए। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>A figure&apos;s text size in points must be %1 to %2. Nothing was drawn.</source>
        <translation>चित्र के पाठ का आकार (पॉइंट में) %1 से %2 तक होना चाहिए। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>A figure&apos;s angle between the eyes in degrees must be %1 to %2. Nothing was drawn.</source>
        <translation>चित्र में आँखों के बीच का कोण (डिग्री में) %1 से %2 तक होना चाहिए। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>A scale of 1:N needs an N above 0. Nothing was drawn.</source>
        <translation>पैमाने 1:N में N शून्य से बड़ा होना चाहिए। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>An anaglyph needs its background: without paper the eyes would see different pages. Choose one of the two.</source>
        <translation>एनाग्लिफ़ को अपनी पृष्ठभूमि चाहिए: काग़ज़ के बिना आँखें अलग-अलग पृष्ठ देखेंगी। दोनों में से एक चुनें।</translation>
    </message>
    <message>
        <source>Two eyes&apos; pictures fill a figure of their own: they need the layout &apos;detail&apos;. Choose it, or an anaglyph.</source>
        <translation>दो आँखों की तस्वीरें अपना अलग चित्र भरती हैं: उन्हें &apos;detail&apos; विन्यास चाहिए। उसे चुनें, या एनाग्लिफ़।</translation>
    </message>
    <message>
        <source>One eye&apos;s picture of two needs the layout &apos;detail&apos; and the stereo &apos;sidebyside&apos; or &apos;overunder&apos;. Choose both eyes, or these.</source>
        <translation>दो में से एक आँख की तस्वीर को &apos;detail&apos; विन्यास और &apos;sidebyside&apos; या &apos;overunder&apos; स्टीरियो चाहिए। दोनों आँखें चुनें, या ये।</translation>
    </message>
    <message>
        <source>A figure with plots needs a recording. Choose one, CSV or HDF5.</source>
        <translation>आरेख वाले चित्र को रिकॉर्डिंग चाहिए। CSV या HDF5 में से एक चुनें।</translation>
    </message>
    <message>
        <source>The package %1 could not be written (%2). Nothing was left behind. Choose another folder or free some space.</source>
        <translation>पैकेज %1 लिखा नहीं जा सका (%2)। कुछ पीछे नहीं छूटा। दूसरा फ़ोल्डर चुनें या जगह खाली करें।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not there. Nothing was packed. Relink it, or take it out of the project.</source>
        <translation>&apos;%1&apos; वहाँ नहीं है। कुछ पैक नहीं हुआ। इसे फिर से जोड़ें, या परियोजना से निकालें।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changed since (checksum differs). Nothing was packed. Relink it, or take it out of the project.</source>
        <translation>&apos;%1&apos; तब से बदल गई है (जाँच-योग अलग है)। कुछ पैक नहीं हुआ। इसे फिर से जोड़ें, या परियोजना से निकालें।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not there. Nothing was packed. It is needed to repeat &apos;%2&apos;: put it back, or take the recording out.</source>
        <translation>&apos;%1&apos; वहाँ नहीं है। कुछ पैक नहीं हुआ। &apos;%2&apos; को दोहराने के लिए यह चाहिए: इसे वापस रखें, या रिकॉर्डिंग निकालें।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changed since (checksum differs). Nothing was packed. It is needed to repeat &apos;%2&apos;: put it back, or take the recording out.</source>
        <translation>&apos;%1&apos; तब से बदल गई है (जाँच-योग अलग है)। कुछ पैक नहीं हुआ। &apos;%2&apos; को दोहराने के लिए यह चाहिए: इसे वापस रखें, या रिकॉर्डिंग निकालें।</translation>
    </message>
    <message>
        <source>%1 would unpack to %2 bytes, more than %3 times its own size. Nothing was unpacked. Ask whoever made it for another.</source>
        <translation>%1 खुलने पर %2 बाइट हो जाएगा, अपने आकार के %3 गुने से अधिक। कुछ नहीं खोला गया। बनाने वाले से दूसरा माँगें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is not a whole zip file. Copy or download it again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह पूरी zip फ़ाइल नहीं है। इसे फिर से कॉपी या डाउनलोड करें।</translation>
    </message>
    <message>
        <source>%1 holds no %2 of relievo.</source>
        <translation>%1 में relievo की %2 नहीं है।</translation>
    </message>
    <message>
        <source>%1 holds no %2 of relievo, so that nothing can be checked. Choose a package for citation.</source>
        <translation>%1 में relievo की %2 नहीं है, इसलिए कुछ जाँचा नहीं जा सकता। उद्धरण वाला पैकेज चुनें।</translation>
    </message>
    <message>
        <source>%1 names a file outside of itself (&apos;%2&apos;). Nothing was unpacked.</source>
        <translation>%1 अपने से बाहर की फ़ाइल (&apos;%2&apos;) का नाम लेता है। कुछ नहीं खोला गया।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be unpacked; is the disk full?</source>
        <translation>&apos;%1&apos; खोली नहीं जा सकती; क्या डिस्क भरी है?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 is damaged.</source>
        <translation>%2 की &apos;%1&apos; क्षतिग्रस्त है।</translation>
    </message>
    <message>
        <source>%1 is not a project of relievo. Nothing was changed. Choose another file.</source>
        <translation>%1 relievo की परियोजना नहीं है। कुछ नहीं बदला गया। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>The project %1 was written by another relievo (schema %2; this one reads %3). Nothing was changed. Use that version, or choose another file.</source>
        <translation>परियोजना %1 किसी दूसरे relievo की है (स्कीमा %2; यह %3 पढ़ता है)। कुछ नहीं बदला गया। वह संस्करण उपयोग करें, या दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>The project %1 is damaged (line %2). Nothing was changed. Choose another file.</source>
        <translation>परियोजना %1 क्षतिग्रस्त है (पंक्ति %2)। कुछ नहीं बदला गया। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>The project %1 is damaged (a part is missing or has another form). Nothing was changed. Choose another file.</source>
        <translation>परियोजना %1 क्षतिग्रस्त है (कोई भाग नहीं है या उसका रूप अलग है)। कुछ नहीं बदला गया। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>The project %1 is damaged (%2). Nothing was changed. Choose another file.</source>
        <translation>परियोजना %1 क्षतिग्रस्त है (%2)। कुछ नहीं बदला गया। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>%1 was made from &apos;%2&apos;, which is not there (E501). Nothing was made. Give its place as FILE.</source>
        <translation>%1 &apos;%2&apos; से बना था, जो वहाँ नहीं है (E501)। कुछ नहीं बना। उसकी जगह फ़ाइल के रूप में दें।</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; goes back in time in row %2. It is not replayed.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; पंक्ति %2 में समय में पीछे जाती है। यह फिर से नहीं चलाई जाती।</translation>
    </message>
    <message>
        <source>Cannot read %1: the picture is damaged. Nothing was restored.</source>
        <translation>%1 पढ़ी नहीं जा सकती: तस्वीर क्षतिग्रस्त है। कुछ वापस नहीं लाया गया।</translation>
    </message>
    <message>
        <source>Cannot read %1: what it carries of relievo is cut off. Nothing was restored.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसमें relievo का जो भाग है वह कटा हुआ है। कुछ वापस नहीं लाया गया।</translation>
    </message>
    <message>
        <source>Cannot read %1: what it says of how it was made is damaged. Nothing was compared.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह कैसे बनी, इसका विवरण क्षतिग्रस्त है। कुछ मिलाया नहीं गया।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2, beyond what it may be.</source>
        <translation>&apos;%1&apos; %2 है, जो सीमा से बाहर है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is beyond what it may be.</source>
        <translation>&apos;%1&apos; सीमा से बाहर है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a whole number.</source>
        <translation>&apos;%1&apos; पूर्ण संख्या नहीं है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has not {2|%2 number|%2 numbers}.</source>
        <translation>&apos;%1&apos; में {2|%2 संख्या नहीं है|%2 संख्याएँ नहीं हैं}।</translation>
    </message>
    <message>
        <source>It is nested too deep.</source>
        <translation>यह बहुत गहराई तक भीतर-भीतर है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a checksum.</source>
        <translation>&apos;%1&apos; जाँच-योग नहीं है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a file&apos;s name.</source>
        <translation>&apos;%1&apos; फ़ाइल का नाम नहीं है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a known &apos;%2&apos;.</source>
        <translation>&apos;%1&apos; &apos;%2&apos; का ज्ञात मान नहीं है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no size.</source>
        <translation>&apos;%1&apos; का कोई आकार नहीं है।</translation>
    </message>
    <message>
        <source>a place of a picture has not 3 numbers.</source>
        <translation>तस्वीर की एक जगह में 3 संख्याएँ नहीं हैं।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no colour.</source>
        <translation>&apos;%1&apos; रंग नहीं है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an object.</source>
        <translation>&apos;%1&apos; ऑब्जेक्ट नहीं है।</translation>
    </message>
    <message>
        <source>There is no &apos;%1&apos; in it.</source>
        <translation>इसमें &apos;%1&apos; नहीं है।</translation>
    </message>
    <message>
        <source>It is of schema %1; this version reads up to %2.</source>
        <translation>यह स्कीमा %1 का है; यह संस्करण %2 तक पढ़ता है।</translation>
    </message>
    <message>
        <source>There is no &apos;relievo_view&apos; of schema 1 in it.</source>
        <translation>इसमें स्कीमा 1 का &apos;relievo_view&apos; नहीं है।</translation>
    </message>
    <message>
        <source>%1 holds no state that this version can read: it is damaged. Nothing was changed.</source>
        <translation>%1 में ऐसी स्थिति नहीं है जिसे यह संस्करण पढ़ सके: वह क्षतिग्रस्त है। कुछ नहीं बदला गया।</translation>
    </message>
    <message>
        <source>%1 holds no state that this version can read: a part is missing or has another form. Nothing was changed.</source>
        <translation>%1 में ऐसी स्थिति नहीं है जिसे यह संस्करण पढ़ सके: कोई भाग नहीं है या उसका रूप अलग है। कुछ नहीं बदला गया।</translation>
    </message>
    <message>
        <source>%1 holds no state that this version can read. %2 Nothing was changed.</source>
        <translation>%1 में ऐसी स्थिति नहीं है जिसे यह संस्करण पढ़ सके। %2 कुछ नहीं बदला गया।</translation>
    </message>
    <message>
        <source>This text is not a view of relievo (it is damaged, or a part is missing). The view was not changed. Copy a view again.</source>
        <translation>यह पाठ relievo का दृश्य नहीं है (यह क्षतिग्रस्त है, या कोई भाग नहीं है)। दृश्य नहीं बदला गया। दृश्य फिर से कॉपी करें।</translation>
    </message>
    <message>
        <source>This text is not a view of relievo (%1). The view was not changed. Copy a view again.</source>
        <translation>यह पाठ relievo का दृश्य नहीं है (%1)। दृश्य नहीं बदला गया। दृश्य फिर से कॉपी करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is missing or not a file. Its checksum was not made.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह नहीं है या फ़ाइल नहीं है। इसका जाँच-योग नहीं बना।</translation>
    </message>
    <message>
        <source>Cannot read %1 to its end. Its checksum was not made.</source>
        <translation>%1 अंत तक नहीं पढ़ी जा सकती। इसका जाँच-योग नहीं बना।</translation>
    </message>
    <message>
        <source>%1 was not seen from the top, so heights are no z of the file. Nothing was written. Choose --view top or view millimetres.</source>
        <translation>%1 ऊपर से नहीं देखी गई, इसलिए ऊँचाइयाँ फ़ाइल का z नहीं हैं। कुछ नहीं लिखा गया। --view top या दृश्य के मिलीमीटर चुनें।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 x %3 cells, but the map is %4 x %5 mm: it is not a raster of the whole map, and was not used. Cut it to the outline of the map.</source>
        <translation>&apos;%1&apos; में %2 x %3 कोशिकाएँ हैं, पर मानचित्र %4 x %5 mm है: यह पूरे मानचित्र का रास्टर नहीं है और काम में नहीं लिया गया। इसे मानचित्र की रूपरेखा तक काटें।</translation>
    </message>
    <message>
        <source>%1: a mesh&apos;s triangles cannot be read in blocks. Nothing was made. Leave out --memory, or save it without faces.</source>
        <translation>%1: जाल के त्रिभुज खंडों में नहीं पढ़े जा सकते। कुछ नहीं बना। --memory छोड़ें, या इसे फलकों के बिना सहेजें।</translation>
    </message>
    <message>
        <source>%1: only LAS, LAZ and binary PLY clouds and rasters are read in blocks. Nothing was made. Convert it to LAS, or leave out --memory.</source>
        <translation>%1: खंडों में केवल LAS, LAZ और बाइनरी PLY के बिंदु-समूह और रास्टर पढ़े जाते हैं। कुछ नहीं बना। इसे LAS में बदलें, या --memory छोड़ें।</translation>
    </message>
    <message>
        <source>%1 and %2 are not of one unit (%3 and %4), so they are no single scan. Nothing was made. Convert one of them, or make a map of each.</source>
        <translation>%1 और %2 एक ही इकाई में नहीं हैं (%3 और %4), इसलिए वे एक स्कैन नहीं हैं। कुछ नहीं बनाया गया। उनमें से एक को बदलें, या हर एक का अलग नक्शा बनाएँ।</translation>
    </message>
    <message>
        <source>%1 and %2 have different reference systems, so they are no single scan. Nothing was made. Convert one of them, or make a map of each.</source>
        <translation>%1 और %2 के संदर्भ तंत्र अलग हैं, इसलिए वे एक स्कैन नहीं हैं। कुछ नहीं बनाया गया। उनमें से एक को बदलें, या हर एक का अलग नक्शा बनाएँ।</translation>
    </message>
    <message>
        <source>%1 cannot be listed: %2. Nothing was made. Check its permissions.</source>
        <translation>%1 की सूची नहीं बन सकी: %2। कुछ नहीं बनाया गया। उसकी अनुमतियाँ जाँचें।</translation>
    </message>
    <message>
        <source>%1 names or holds no LAS, LAZ or PLY file. Nothing was made. Choose another folder or list.</source>
        <translation>%1 में कोई LAS, LAZ या PLY फ़ाइल नहीं है। कुछ नहीं बनाया गया। कोई दूसरा फ़ोल्डर या सूची चुनें।</translation>
    </message>
    <message>
        <source>No file fits %1. Nothing was made. Check the pattern.</source>
        <translation>%1 से कोई फ़ाइल मेल नहीं खाती। कुछ नहीं बनाया गया। पैटर्न जाँचें।</translation>
    </message>
    <message>
        <source>%1 names %2, and there is no such file. Nothing was made. Correct the list.</source>
        <translation>%1 में %2 का नाम है, पर ऐसी कोई फ़ाइल नहीं है। कुछ नहीं बनाया गया। सूची ठीक करें।</translation>
    </message>
    <message>
        <source>%1 is longer than lists of files are (64 MB). Nothing was made. Divide it, or name a folder.</source>
        <translation>%1 फ़ाइलों की सूचियों की सीमा (64 MB) से लंबी है। कुछ नहीं बनाया गया। उसे बाँटें, या कोई फ़ोल्डर दें।</translation>
    </message>
    <message>
        <source>%1 cannot be read as a tile index: it is damaged, or one of its features names no file. Nothing was made. Make it anew, or name a folder.</source>
        <translation>%1 को टाइल-सूची के रूप में नहीं पढ़ा जा सका: वह ख़राब है, या उसकी कोई प्रविष्टि फ़ाइल का नाम नहीं देती। कुछ नहीं बनाया गया। उसे फिर से बनाएँ, या कोई फ़ोल्डर दें।</translation>
    </message>
    <message>
        <source>%1 names %2, which is no file of this computer. Nothing was made. Fetch the files first.</source>
        <translation>%1 में %2 का नाम है, जो इस कंप्यूटर की फ़ाइल नहीं है। कुछ नहीं बनाया गया। पहले फ़ाइलें ले आएँ।</translation>
    </message>
    <message>
        <source>Several files become one map by tiles only. Nothing was made. Give --memory as well, or join them with relievo prepare.</source>
        <translation>कई फ़ाइलें केवल टाइलों से ही एक नक्शा बनती हैं। कुछ नहीं बनाया गया। --memory भी दें, या उन्हें relievo prepare से जोड़ें।</translation>
    </message>
    <message>
        <source>%1 holds work on another map: %2 differs. Nothing was made. Give the same files and options as then, or another folder with --job.</source>
        <translation>%1 में किसी दूसरे नक्शे का काम है: %2 अलग है। कुछ नहीं बनाया गया। तब जैसी ही फ़ाइलें और विकल्प दें, या --job से कोई दूसरा फ़ोल्डर।</translation>
    </message>
    <message>
        <source>Another process works in %1. Nothing was made. Wait until it ends, or give another folder with --job.</source>
        <translation>%1 में कोई दूसरी प्रक्रिया काम कर रही है। कुछ नहीं बनाया गया। उसके समाप्त होने तक रुकें, या --job से कोई दूसरा फ़ोल्डर दें।</translation>
    </message>
    <message>
        <source>%1 is not empty and holds no work of this program. Nothing was made. Give an empty or a new folder with --job.</source>
        <translation>%1 ख़ाली नहीं है और उसमें इस प्रोग्राम का कोई काम नहीं है। कुछ नहीं बनाया गया। --job से कोई ख़ाली या नया फ़ोल्डर दें।</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. What was finished before stays in its folder. Free some space, and give the same command again.</source>
        <translation>%1 नहीं लिखा जा सका: %2। जो पहले पूरा हुआ था, वह अपने फ़ोल्डर में रहता है। जगह ख़ाली करें, और वही कमांड फिर दें।</translation>
    </message>
    <message>
        <source>%1: none of its points that were looked at is finite. Nothing was made.</source>
        <translation>%1: देखे गए बिंदुओं में से कोई परिमित नहीं है। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>A raster is a height map already and is seen from the top only.</source>
        <translation>रास्टर पहले से ऊँचाई-मानचित्र है और केवल ऊपर से देखा जाता है।</translation>
    </message>
    <message>
        <source>A map of %1 x %2 cells needs at least %3 MB of memory when made by tiles; %4 MB are allowed. Nothing was made. Allow more with --memory, or choose larger cells.</source>
        <translation>%1 x %2 कोशिकाओं के मानचित्र को टाइलों से बनाने में कम से कम %3 MB मेमोरी चाहिए; %4 MB की अनुमति है। कुछ नहीं बना। --memory से अधिक दें, या बड़ी कोशिकाएँ चुनें।</translation>
    </message>
    <message>
        <source>There is no level %1.</source>
        <translation>स्तर %1 नहीं है।</translation>
    </message>
    <message>
        <source>This needs about %1; %2 are free. Nothing was made. Choose cells of at least %3 (%4), or close other programs.</source>
        <translation>इसके लिए लगभग %1 चाहिए; %2 खाली है। कुछ नहीं बनाया गया। कम से कम %3 के खाने चुनें (%4), या दूसरे प्रोग्राम बंद करें।</translation>
    </message>
    <message>
        <source>%1: every height is the one that stands for none, so there is no surface. Nothing was made. Choose another --nodata.</source>
        <translation>%1: हर ऊँचाई वही है जो &quot;कोई नहीं&quot; के लिए है, इसलिए कोई सतह नहीं है। कुछ नहीं बनाया गया। दूसरा --nodata चुनें।</translation>
    </message>
    <message>
        <source>%1: no point is left to make a surface from. Nothing was made. Choose another --nodata.</source>
        <translation>%1: सतह बनाने के लिए कोई बिंदु नहीं बचा। कुछ नहीं बना। दूसरा --nodata चुनें।</translation>
    </message>
    <message>
        <source>%1: seen from here all points lie on one spot, so there is no surface. Nothing was made. Choose another view or another file.</source>
        <translation>%1: यहाँ से देखने पर सभी बिंदु एक ही जगह हैं, इसलिए कोई सतह नहीं है। कुछ नहीं बना। दूसरा दृश्य या दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Give the number of cells or their spacing, not both.</source>
        <translation>कोशिकाओं की संख्या या उनकी दूरी दें, दोनों नहीं।</translation>
    </message>
    <message>
        <source>The spacing must be above 0 mm.</source>
        <translation>दूरी 0 mm से अधिक होनी चाहिए।</translation>
    </message>
    <message>
        <source>The grid needs at least 2 cells across.</source>
        <translation>ग्रिड में कम से कम 2 कोशिकाएँ आर-पार चाहिए।</translation>
    </message>
    <message>
        <source>A grid of %1 x %2 cells is larger than this version can hold (16384 x 16384). Choose fewer cells, or have the map made by tiles (--memory).</source>
        <translation>%1 x %2 कोशिकाओं का ग्रिड इस संस्करण की क्षमता (16384 x 16384) से बड़ा है। कम कोशिकाएँ चुनें, या मानचित्र टाइलों से बनवाएँ (--memory)।</translation>
    </message>
    <message>
        <source>A grid of %1 x %2 cells is larger than maps by tiles can be (2^40 cells, 2^23 a side). Choose fewer cells.</source>
        <translation>%1 x %2 कोशिकाओं का ग्रिड टाइलों से बने मानचित्रों की सीमा (2^40 कोशिकाएँ, प्रति भुजा 2^23) से बड़ा है। कम कोशिकाएँ चुनें।</translation>
    </message>
    <message>
        <source>A map of %1 x %2 cells needs about %3 MB on the disk of %4 while it is made; %5 MB are free. Nothing was made. Free some space, or choose larger cells.</source>
        <translation>%1 x %2 कोशिकाओं का मानचित्र बनाते समय %4 की डिस्क पर लगभग %3 MB चाहिए; %5 MB खाली हैं। कुछ नहीं बनाया गया। जगह खाली करें, या बड़ी कोशिकाएँ चुनें।</translation>
    </message>
    <message>
        <source>The relief image &apos;natural&apos; cannot be drawn: this surface has no colours. Choose another, for example &apos;lit&apos;.</source>
        <translation>उभार-चित्र “प्राकृतिक रंग” नहीं बनाया जा सकता: इस सतह में रंग नहीं हैं। कोई दूसरा चुनें, जैसे छायांकित उभार।</translation>
    </message>
    <message>
        <source>The relief image &apos;intensity&apos; cannot be drawn: this surface has no intensities. Choose another, for example &apos;lit&apos;.</source>
        <translation>उभार-चित्र “तीव्रता” नहीं बनाया जा सकता: इस सतह में तीव्रताएँ नहीं हैं। कोई दूसरा चुनें, जैसे छायांकित उभार।</translation>
    </message>
    <message>
        <source>An angle needs three different points.</source>
        <translation>कोण को तीन अलग बिंदु चाहिए।</translation>
    </message>
    <message>
        <source>The profile&apos;s line is not on the object.</source>
        <translation>परिच्छेद की रेखा वस्तु पर नहीं है।</translation>
    </message>
    <message>
        <source>The outline crosses itself, so that it has no inside. Choose its corners in order.</source>
        <translation>रूपरेखा स्वयं को काटती है, इसलिए उसका कोई भीतर नहीं है। कोने क्रम से चुनें।</translation>
    </message>
    <message>
        <source>The corners lie on one line, so that there is no area among them. Choose others.</source>
        <translation>कोने एक ही रेखा पर हैं, उनके बीच कोई क्षेत्र नहीं है। दूसरे चुनें।</translation>
    </message>
    <message>
        <source>The plane does not cut the surface. Choose another plane.</source>
        <translation>समतल सतह को नहीं काटता। दूसरा समतल चुनें।</translation>
    </message>
    <message>
        <source>The plane of &apos;%1&apos; does not cut the surface. Choose another plane.</source>
        <translation>&apos;%1&apos; का तल सतह को नहीं काटता। दूसरा तल चुनें।</translation>
    </message>
    <message>
        <source>A measurement of kind %1 needs %2 places.</source>
        <translation>%1 प्रकार के माप को %2 जगहें चाहिए।</translation>
    </message>
    <message>
        <source>There is no surface at x %1, y %2 mm. Choose a place on the object.</source>
        <translation>x %1, y %2 mm पर कोई सतह नहीं है। वस्तु पर कोई जगह चुनें।</translation>
    </message>
    <message>
        <source>A profile needs at least two places.</source>
        <translation>परिच्छेद को कम से कम दो जगहें चाहिए।</translation>
    </message>
    <message>
        <source>The plane cuts this map in more than %1 points. Choose another plane, or make a map with coarser cells.</source>
        <translation>तल इस मानचित्र को %1 से अधिक बिंदुओं में काटता है। दूसरा तल चुनें, या मोटी कोशिकाओं वाला मानचित्र बनाएँ।</translation>
    </message>
    <message>
        <source>A section&apos;s plane goes through one, two or three places.</source>
        <translation>काट का तल एक, दो या तीन जगहों से गुज़रता है।</translation>
    </message>
    <message>
        <source>Two places, one above the other, give no plane. Choose another.</source>
        <translation>एक के ऊपर एक दो जगहें समतल नहीं बनातीं। दूसरी चुनें।</translation>
    </message>
    <message>
        <source>Three places on one line give no plane. Choose another.</source>
        <translation>एक रेखा पर तीन जगहें समतल नहीं बनातीं। दूसरी चुनें।</translation>
    </message>
    <message>
        <source>A section needs a plane with a direction and a distance.</source>
        <translation>काट को दिशा और दूरी वाला तल चाहिए।</translation>
    </message>
    <message>
        <source>The shading of a scan&apos;s own colours must lie between 0 and 1.</source>
        <translation>स्कैन के अपने रंगों का छायांकन 0 और 1 के बीच होना चाहिए।</translation>
    </message>
    <message>
        <source>The colours&apos; upper end must lie above their lower end.</source>
        <translation>रंगों का ऊपरी छोर निचले छोर से ऊपर होना चाहिए।</translation>
    </message>
    <message>
        <source>A light needs a direction and a height of 0 to 90 degrees.</source>
        <translation>प्रकाश को दिशा और 0 से 90 डिग्री की ऊँचाई चाहिए।</translation>
    </message>
    <message>
        <source>The radius of a relief image must be 0 (automatic) or more millimetres.</source>
        <translation>उभार-चित्र की त्रिज्या 0 (अपने-आप) या अधिक मिलीमीटर होनी चाहिए।</translation>
    </message>
    <message>
        <source>This surface has no colours of its own. Choose another relief image.</source>
        <translation>इस सतह के अपने रंग नहीं हैं। दूसरा उभार-चित्र चुनें।</translation>
    </message>
    <message>
        <source>This surface has no intensities of its own. Choose another relief image.</source>
        <translation>इस सतह की अपनी तीव्रताएँ नहीं हैं। दूसरा उभार-चित्र चुनें।</translation>
    </message>
    <message>
        <source>Two pictures of one size are needed for an anaglyph.</source>
        <translation>एनाग्लिफ़ के लिए एक ही आकार की दो तस्वीरें चाहिए।</translation>
    </message>
    <message>
        <source>The plane of zero parallax, %1 mm, lies far from the heights here, %2 to %3 mm. Nothing was drawn. Choose one among them.</source>
        <translation>शून्य लंबन का तल, %1 mm, यहाँ की ऊँचाइयों %2 से %3 mm से बहुत दूर है। कुछ नहीं बनाया गया। उनके बीच का कोई चुनें।</translation>
    </message>
    <message>
        <source>There is no level %1; this map has levels 0 to %2. Choose one of them.</source>
        <translation>स्तर %1 नहीं है; इस मानचित्र में स्तर 0 से %2 हैं। उनमें से एक चुनें।</translation>
    </message>
    <message>
        <source>A region needs a position and a width and height above 0, in millimetres. Nothing was changed.</source>
        <translation>विंडो को स्थान और 0 से अधिक चौड़ाई व ऊँचाई मिलीमीटर में चाहिए। कुछ नहीं बदला गया।</translation>
    </message>
    <message>
        <source>The region names a level that the pyramid does not have.</source>
        <translation>विंडो ऐसे स्तर का नाम लेती है जो पिरामिड में नहीं है।</translation>
    </message>
    <message>
        <source>A region needs a finite position and a side above 0 mm.</source>
        <translation>विंडो को परिमित स्थान और 0 mm से बड़ी भुजा चाहिए।</translation>
    </message>
    <message>
        <source>The camera path &quot;%1&quot; needs at least two key views. Nothing was made.</source>
        <translation>कैमरा पथ &quot;%1&quot; को कम से कम दो मुख्य दृश्य चाहिए। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>The camera path &quot;%1&quot; cannot be followed: key view %2 is not later than the one before it.</source>
        <translation>कैमरा पथ &quot;%1&quot; पर चला नहीं जा सकता: मुख्य दृश्य %2 पिछले के बाद का नहीं है।</translation>
    </message>
    <message>
        <source>The camera path &quot;%1&quot; cannot be followed: key view %2 has no size or no place.</source>
        <translation>कैमरा पथ &quot;%1&quot; पर चला नहीं जा सकता: मुख्य दृश्य %2 का आकार या स्थान नहीं है।</translation>
    </message>
    <message>
        <source>A video&apos;s width in pixels must be %1 to %2. Nothing was made.</source>
        <translation>वीडियो की चौड़ाई (पिक्सेल में) %1 से %2 तक होना चाहिए। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>A video&apos;s height in pixels must be %1 to %2. Nothing was made.</source>
        <translation>वीडियो की ऊँचाई (पिक्सेल में) %1 से %2 तक होना चाहिए। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>A video&apos;s frames per second must be %1 to %2. Nothing was made.</source>
        <translation>वीडियो के प्रति सेकंड फ़्रेम %1 से %2 तक होना चाहिए। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>A video&apos;s speed must be %1 to %2. Nothing was made.</source>
        <translation>वीडियो की गति %1 से %2 तक होना चाहिए। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>A video&apos;s angle between the eyes in degrees must be %1 to %2. Nothing was made.</source>
        <translation>वीडियो में आँखों के बीच का कोण (डिग्री में) %1 से %2 तक होना चाहिए। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>A video&apos;s width and height must be even. Nothing was made.</source>
        <translation>वीडियो की चौड़ाई और ऊँचाई सम संख्याएँ होनी चाहिए। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>A video needs a recording or a camera path. Nothing was made.</source>
        <translation>वीडियो को रिकॉर्डिंग या कैमरा पथ चाहिए। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>There is nothing between %1 s and %2 s: the recording is %3 s long. Nothing was made.</source>
        <translation>%1 s और %2 s के बीच कुछ नहीं है: रिकॉर्डिंग %3 s लंबी है। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>There is nothing between %1 s and %2 s: the camera path is %3 s long. Nothing was made.</source>
        <translation>%1 s और %2 s के बीच कुछ नहीं है: कैमरा पथ %3 s लंबा है। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>This would be more than a million frames. Choose a part of the recording.</source>
        <translation>ये दस लाख से अधिक फ़्रेम होंगे। रिकॉर्डिंग का एक भाग चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: there is no such file. Check the name and the folder.</source>
        <translation>%1 पढ़ी नहीं जा सकती: ऐसी कोई फ़ाइल नहीं है। नाम और फ़ोल्डर जाँचें।</translation>
    </message>
    <message>
        <source>Cannot read %1: this account may not read it. Change its permissions, or copy it.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इस खाते को अनुमति नहीं है। अनुमति बदलें या फ़ाइल की प्रति बनाएँ।</translation>
    </message>
    <message>
        <source>Cannot read %1: its links lead in a circle. Choose the file itself.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसके लिंक चक्र में जाते हैं। स्वयं फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: %2. Choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: %2। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: %2.</source>
        <translation>%1 पढ़ी नहीं जा सकती: %2।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is a folder. Choose one of the files in it.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह फ़ोल्डर है। इसकी कोई फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is a pipe or device, not a file. Save the scan to a file first.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह पाइप या उपकरण है, फ़ाइल नहीं। पहले स्कैन को फ़ाइल में सहेजें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is empty (0 bytes). Copy or export it again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह खाली है (0 बाइट)। इसे फिर से कॉपी या निर्यात करें।</translation>
    </message>
    <message>
        <source>Cannot read %1 as a scan: it is %2. Open it as a raster.</source>
        <translation>%1 को स्कैन के रूप में नहीं पढ़ा जा सकता: यह %2 है। इसे रास्टर के रूप में खोलें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it has %2 bytes, more than the %3 that such a file may have. Nothing was loaded.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसमें %2 बाइट हैं, ऐसी फ़ाइल के लिए अनुमत %3 से अधिक। कुछ नहीं लोड किया गया।</translation>
    </message>
    <message>
        <source>Cannot write %1 (%2). What was there is as before. Choose another folder or free some space.</source>
        <translation>%1 लिखा नहीं जा सकता (%2)। जो वहाँ था वह वैसा ही है। दूसरा फ़ोल्डर चुनें या जगह खाली करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: its header has no end (%2). Copy or export it again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसके शीर्ष का अंत नहीं है (%2)। इसे फिर से कॉपी या निर्यात करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises {2|%2 point|%2 points}, file ends at %3. Nothing was loaded. Choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: शीर्ष %2 बिंदु बताता है, फ़ाइल %3 पर समाप्त होती है। कुछ नहीं खोला गया। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises {2|%2 point|%2 points}, file ends at %3. Nothing was loaded. Load the {4|%4 complete point|%4 complete points}, or choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: शीर्ष %2 बिंदु बताता है, फ़ाइल %3 पर समाप्त होती है। कुछ नहीं खोला गया। {4|%4 पूरा बिंदु|%4 पूरे बिंदु} खोलें या दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it has {2|%2 point|%2 points}, none finite. Choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसमें %2 बिंदु {2|है, वह परिमित नहीं|हैं, कोई भी परिमित नहीं}। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: the system stopped the import, probably for lack of memory. Close other programs, or thin the scan out first.</source>
        <translation>%1 पढ़ी नहीं जा सकती: सिस्टम ने पढ़ना रोक दिया, संभवतः स्मृति की कमी से। दूसरे प्रोग्राम बंद करें या पहले स्कैन को विरल करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: its points have no %2 coordinate. Export it with x, y and z.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसके बिंदुओं में %2 निर्देशांक नहीं है। इसे x, y और z के साथ निर्यात करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds no rows of numbers. Choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसमें संख्याओं की पंक्तियाँ नहीं हैं। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it has 0 points. Choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसमें 0 बिंदु हैं। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds 0 triangles. Choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसमें 0 त्रिभुज हैं। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: its header promises no vertices. Choose a file with points.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसका शीर्ष कोई बिंदु नहीं बताता। बिंदुओं वाली फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: its header names no format. Export it again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसका शीर्ष कोई प्रारूप नहीं बताता। इसे फिर से निर्यात करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is shorter than the header of a LAS file. Copy or export it again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह LAS फ़ाइल के शीर्ष से भी छोटा है। इसे फिर से कॉपी या निर्यात करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is shorter than the header of an E57 file. Copy or export it again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह E57 फ़ाइल के शीर्ष से भी छोटा है। इसे फिर से कॉपी या निर्यात करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is shorter than the header of an STL file. Copy or export it again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह STL फ़ाइल के शीर्ष से भी छोटा है। इसे फिर से कॉपी या निर्यात करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: its points cannot be decoded. The file is damaged; export it again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसके बिंदु पढ़े नहीं जा सके। फ़ाइल क्षतिग्रस्त है; इसे फिर से निर्यात करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it became shorter while it was read, or its disk failed. Try again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: पढ़ते समय यह छोटा हो गया, या इसकी डिस्क विफल हुई। फिर कोशिश करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it was changed while it was read. Try again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: पढ़ते समय यह बदल गया। फिर कोशिश करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is a colour picture, not a height raster. Choose the raster with one band of heights.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह रंगीन चित्र है, ऊँचाई रास्टर नहीं। ऊँचाइयों के एक बैंड वाला रास्टर चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: its pixels are measured in degrees. Reproject it to metres, for example gdalwarp -t_srs EPSG:UTM-ZONE.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसके पिक्सेल डिग्री में हैं। इसे मीटर में बदलें, जैसे gdalwarp -t_srs EPSG:UTM-ZONE.</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds the colours of a map&apos;s cells, not heights. Open the map beside it.</source>
        <translation>%1 पढ़ा नहीं जा सकता: इसमें मानचित्र की कोशिकाओं के रंग हैं, ऊँचाइयाँ नहीं। इसके साथ वाला मानचित्र खोलें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds the intensities of a map&apos;s cells, not heights. Open the map beside it.</source>
        <translation>%1 पढ़ा नहीं जा सकता: इसमें मानचित्र की कोशिकाओं की तीव्रताएँ हैं, ऊँचाइयाँ नहीं। इसके साथ वाला मानचित्र खोलें।</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not a number from -1e12 to 1e12.</source>
        <translation>%1: &apos;%2&apos; -1e12 से 1e12 तक की संख्या नहीं है।</translation>
    </message>
    <message>
        <source>%1: %2 is not a whole number.</source>
        <translation>%1: %2 पूर्ण संख्या नहीं है।</translation>
    </message>
    <message>
        <source>%1: there is no &apos;%2&apos;; there are %3.</source>
        <translation>%1: &apos;%2&apos; नहीं है; ये हैं: %3।</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is none of %3.</source>
        <translation>%1: &apos;%2&apos; इनमें से कोई नहीं है: %3।</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is neither %3 nor %4.</source>
        <translation>%1: &apos;%2&apos; न %3 है न %4।</translation>
    </message>
    <message>
        <source>%1 must be from %2 to %3.</source>
        <translation>%1 %2 से %3 तक होना चाहिए।</translation>
    </message>
    <message>
        <source>%1 needs {2|%2 number|%2 numbers} separated by commas, not &apos;%3&apos;.</source>
        <translation>%1 को अल्पविराम से अलग {2|%2 संख्या|%2 संख्याएँ} चाहिए, &apos;%3&apos; नहीं।</translation>
    </message>
    <message>
        <source>%1 needs %2. Nothing was made. Give that as well, or leave %1 out.</source>
        <translation>%1 को %2 चाहिए। कुछ नहीं बना। वह भी दें, या %1 छोड़ दें।</translation>
    </message>
    <message>
        <source>--parts: &apos;%1&apos; is no list of scan numbers from 1, such as 1,3.</source>
        <translation>--parts: &apos;%1&apos; स्कैनों के क्रमांकों की सूची, 1 से, जैसे 1,3, नहीं है।</translation>
    </message>
    <message>
        <source>--holes: the largest area must not be below 0.</source>
        <translation>--holes: सबसे बड़ा क्षेत्र 0 से कम नहीं होना चाहिए।</translation>
    </message>
    <message>
        <source>--cells must be at least 2.</source>
        <translation>--cells कम से कम 2 होना चाहिए।</translation>
    </message>
    <message>
        <source>--spacing must be above 0 mm.</source>
        <translation>--spacing 0 mm से अधिक होना चाहिए।</translation>
    </message>
    <message>
        <source>Give --cells or --spacing, not both.</source>
        <translation>--cells या --spacing दें, दोनों नहीं।</translation>
    </message>
    <message>
        <source>--factor must be from 1.1 to 8.</source>
        <translation>--factor 1.1 से 8 तक होना चाहिए।</translation>
    </message>
    <message>
        <source>--memory must be a number of megabytes above 0.</source>
        <translation>--memory 0 से अधिक मेगाबाइट की संख्या होनी चाहिए।</translation>
    </message>
    <message>
        <source>--memory must be from 64 MB to 1000000000 MB.</source>
        <translation>--memory 64 MB से 1000000000 MB तक होना चाहिए।</translation>
    </message>
    <message>
        <source>--light: the elevation must be between 0 and 90 degrees.</source>
        <translation>--light: ऊँचाई 0 और 90 अंश के बीच होनी चाहिए।</translation>
    </message>
    <message>
        <source>--radius: it must be 0 (automatic) or more millimetres.</source>
        <translation>--radius: यह 0 (स्वचालित) या अधिक मिलीमीटर होना चाहिए।</translation>
    </message>
    <message>
        <source>--shading: it must be between 0, as photographed, and 1.</source>
        <translation>--shading: यह 0, जैसा फ़ोटो में, और 1 के बीच होना चाहिए।</translation>
    </message>
    <message>
        <source>--quality is for maps that are made in memory. Leave out --memory.</source>
        <translation>--quality स्मृति में बनने वाले मानचित्रों के लिए है। --memory छोड़ दें।</translation>
    </message>
    <message>
        <source>a raster has no points to be read.</source>
        <translation>रास्टर में पढ़ने के लिए कोई बिंदु नहीं हैं।</translation>
    </message>
    <message>
        <source>--scale: &apos;%1&apos; is not of the form 1:N. Nothing was drawn.</source>
        <translation>--scale: &apos;%1&apos; का रूप 1:N नहीं है। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>--scale: the width follows from it. Leave out --width-mm, or --scale.</source>
        <translation>--scale: चौड़ाई इसी से निकलती है। --width-mm छोड़ दें, या --scale।</translation>
    </message>
    <message>
        <source>--measure: &apos;%1&apos; is not of the form NAME:KIND:X,Y;X,Y.</source>
        <translation>--measure: &apos;%1&apos; का रूप NAME:KIND:X,Y;X,Y नहीं है।</translation>
    </message>
    <message>
        <source>--measure: &apos;%1&apos; has two planes.</source>
        <translation>--measure: &apos;%1&apos; में दो तल हैं।</translation>
    </message>
    <message>
        <source>Give one of --from-image and --project. Nothing was drawn.</source>
        <translation>--from-image और --project में से एक दें। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>Give FILE, --project or --from-image. Nothing was drawn.</source>
        <translation>FILE, --project या --from-image दें। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>--%1: the image says this already. Leave it out, or leave out --from-image. Nothing was drawn.</source>
        <translation>--%1: चित्र यह पहले से बताता है। इसे छोड़ दें, या --from-image छोड़ दें। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>--%1: the project says this already. Leave it out, or leave out --project. Nothing was drawn.</source>
        <translation>--%1: परियोजना यह पहले से बताती है। इसे छोड़ दें, या --project छोड़ दें। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>%1 shows no region that relievo could draw again. Nothing was made. Choose a picture or log as relievo wrote it; other programs may drop what is inside.</source>
        <translation>%1 कोई ऐसा क्षेत्र नहीं दिखाता जिसे relievo फिर बना सके। कुछ नहीं बना। ऐसा चित्र या लॉग चुनें जैसा relievo ने लिखा; दूसरे प्रोग्राम अंदर की जानकारी हटा सकते हैं।</translation>
    </message>
    <message>
        <source>The map of &apos;%1&apos; has no level %2. Nothing was drawn.</source>
        <translation>&apos;%1&apos; के मानचित्र में स्तर %2 नहीं है। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>--pixels: of two pictures in one file each has %1 to %2. Nothing was drawn.</source>
        <translation>--pixels: एक फ़ाइल के दो चित्रों में हर एक के %1 से %2 होते हैं। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>A picture&apos;s name ends in .png or .tif; &apos;%1&apos; does not. Nothing was drawn.</source>
        <translation>चित्र का नाम .png या .tif पर समाप्त होता है; &apos;%1&apos; नहीं। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not one of its words.</source>
        <translation>%1: &apos;%2&apos; इसके शब्दों में से नहीं है।</translation>
    </message>
    <message>
        <source>--size must be WIDTHxHEIGHT, like 1280x720.</source>
        <translation>--size चौड़ाईxऊँचाई होना चाहिए, जैसे 1280x720।</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; does not say how its map was made; an older version wrote it. Nothing was made. Replay it in the window on the open map.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; नहीं बताती कि उसका मानचित्र कैसे बना; उसे पुराने संस्करण ने लिखा। कुछ नहीं बना। उसे खिड़की में खुले मानचित्र पर चलाएँ।</translation>
    </message>
    <message>
        <source>--frame: there {1|is %1 frame|are %1 frames}, counted from 0. Nothing was drawn.</source>
        <translation>--frame: %1 फ़्रेम हैं, 0 से गिने हुए। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>The project &quot;%1&quot; has no camera path. Nothing was made. Add key views in the window.</source>
        <translation>परियोजना &quot;%1&quot; में कैमरा पथ नहीं है। कुछ नहीं बना। खिड़की में मुख्य दृश्य जोड़ें।</translation>
    </message>
    <message>
        <source>Give a recording, or a project with --path. Nothing was made.</source>
        <translation>रिकॉर्डिंग दें, या --path के साथ परियोजना। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>--classes: a class is from 0 to 255.</source>
        <translation>--classes: वर्ग 0 से 255 तक होता है।</translation>
    </message>
    <message>
        <source>--sparse needs two or three numbers separated by commas, not &apos;%1&apos;.</source>
        <translation>--sparse को अल्पविराम से अलग दो या तीन संख्याएँ चाहिए, &apos;%1&apos; नहीं।</translation>
    </message>
    <message>
        <source>--reference: scans are counted from 1.</source>
        <translation>--reference: स्कैन 1 से गिने जाते हैं।</translation>
    </message>
    <message>
        <source>--reference needs more than one FILE.</source>
        <translation>--reference को एक से अधिक FILE चाहिए।</translation>
    </message>
    <message>
        <source>--seed belongs to --align and --base. Give one, or leave it out.</source>
        <translation>--seed --align और --base के लिए है। एक दें, या इसे छोड़ दें।</translation>
    </message>
    <message>
        <source>%1: the recipe says what is done. Leave one of them out.</source>
        <translation>%1: विधि बताती है कि क्या होगा। दोनों में से एक छोड़ दें।</translation>
    </message>
    <message>
        <source>The reference is scan %1, but there {2|is|are} only %2.</source>
        <translation>संदर्भ स्कैन %1 है, पर केवल %2 {2|है|हैं}।</translation>
    </message>
    <message>
        <source>There is no FILE to prepare. Nothing was done.</source>
        <translation>तैयार करने के लिए कोई FILE नहीं है। कुछ नहीं किया गया।</translation>
    </message>
    <message>
        <source>%1, line %2: %3. Nothing was done. Its first line is %4; then one pair a line.</source>
        <translation>%1, पंक्ति %2: %3। कुछ नहीं किया गया। पहली पंक्ति %4 है; फिर हर पंक्ति में एक जोड़ा।</translation>
    </message>
    <message>
        <source>-o: &apos;%1&apos; is no .ply. Nothing was done.</source>
        <translation>-o: &apos;%1&apos; .ply नहीं है। कुछ नहीं किया गया।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs &apos;%2&apos;, which the package does not hold. Nothing outside of it was read. Ask whoever made it for a whole one.</source>
        <translation>&apos;%1&apos; को &apos;%2&apos; चाहिए, जो पैकेज में नहीं है। उसके बाहर कुछ नहीं पढ़ा गया। बनाने वाले से पूरा माँगें।</translation>
    </message>
    <message>
        <source>The package does not hold its input, so that nothing can be replayed. Give the file with --input; its checksum is %1.</source>
        <translation>पैकेज में उसका इनपुट नहीं है, इसलिए कुछ दोहराया नहीं जा सकता। फ़ाइल --input से दें; उसका चेकसम %1 है।</translation>
    </message>
    <message>
        <source>No folder to unpack the package can be made. Set TMPDIR to another one.</source>
        <translation>पैकेज खोलने के लिए फ़ोल्डर नहीं बन सकता। TMPDIR दूसरा रखें।</translation>
    </message>
    <message>
        <source>--output is for a single recording; a package is only checked. Nothing was replayed. Leave it out.</source>
        <translation>--output एक अकेली रिकॉर्डिंग के लिए है; पैकेज केवल जाँचा जाता है। कुछ नहीं दोहराया गया। इसे छोड़ दें।</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; lacks its last lines: the program or the computer ended while it recorded, or the disk was full. It cannot be verified. Show it with Record &gt; Replay, or make a video.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; में अंतिम पंक्तियाँ नहीं हैं: रिकॉर्ड करते समय प्रोग्राम या कंप्यूटर बंद हुआ, या डिस्क भर गई। उसे जाँचा नहीं जा सकता। उसे रिकॉर्ड &gt; दोबारा चलाएँ से दिखाएँ, या वीडियो बनाएँ।</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; does not say what made it; only logs of touch, record and the window can be replayed.</source>
        <translation>लॉग &quot;%1&quot; नहीं बताता कि वह किससे बना; केवल touch, record और खिड़की के लॉग दोहराए जा सकते हैं।</translation>
    </message>
    <message>
        <source>The log was made by a command that this version does not understand: %1.</source>
        <translation>लॉग ऐसे आदेश से बना जिसे यह संस्करण नहीं समझता: %1।</translation>
    </message>
    <message>
        <source>Window %1 is not what was touched: its depth map cannot be made again as it was. Nothing was replayed.</source>
        <translation>खिड़की %1 वह नहीं है जिसे छुआ गया: उसका गहराई मानचित्र वैसा फिर नहीं बन सकता। कुछ नहीं दोहराया गया।</translation>
    </message>
    <message>
        <source>The map of the recording has no level %1. Nothing was replayed.</source>
        <translation>रिकॉर्डिंग के मानचित्र में स्तर %1 नहीं है। कुछ नहीं दोहराया गया।</translation>
    </message>
    <message>
        <source>The recording does not say how one of its maps was made. Nothing was replayed.</source>
        <translation>रिकॉर्डिंग नहीं बताती कि उसका एक मानचित्र कैसे बना। कुछ नहीं दोहराया गया।</translation>
    </message>
    <message>
        <source>project new needs -o PROJECT.json.</source>
        <translation>project new को -o PROJECT.json चाहिए।</translation>
    </message>
    <message>
        <source>project package needs -o PACKAGE.zip.</source>
        <translation>project package को -o PACKAGE.zip चाहिए।</translation>
    </message>
    <message>
        <source>%1 shows no region, so that no project can be made from it. Choose a picture or log that relievo wrote.</source>
        <translation>%1 कोई क्षेत्र नहीं दिखाता, इसलिए उससे परियोजना नहीं बन सकती। relievo का लिखा चित्र या लॉग चुनें।</translation>
    </message>
    <message>
        <source>%1 is a recording of %2, and %3 shows another file. No project was written. Leave it out.</source>
        <translation>%1 %2 की रिकॉर्डिंग है, और %3 दूसरी फ़ाइल दिखाता है। कोई परियोजना नहीं लिखी गई। इसे छोड़ दें।</translation>
    </message>
    <message>
        <source>%1 belongs to project %2, not to %3. Nothing was done. Leave it out.</source>
        <translation>%1 project %2 के लिए है, %3 के लिए नहीं। कुछ नहीं किया गया। इसे छोड़ दें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is a package for citation, not a scan. &apos;relievo project info&apos; says what it holds, &apos;relievo project verify&apos; whether all of it is as it was packed.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह उद्धरण वाला पैकेज है, स्कैन नहीं। &apos;relievo project info&apos; बताता है कि इसमें क्या है, और &apos;relievo project verify&apos; बताता है कि सब कुछ वैसा ही है या नहीं जैसा पैक किया गया था।</translation>
    </message>
    <message>
        <source>--relief: &apos;%1&apos; has no values of the relief. Choose another, or &apos;relievo render&apos;; colours are written beside a map without --relief.</source>
        <translation>--relief: &apos;%1&apos; में उभार के मान नहीं हैं। दूसरा चुनें, या &apos;relievo render&apos;; --relief के बिना रंग मानचित्र के साथ लिखे जाते हैं।</translation>
    </message>
    <message>
        <source>--relief: its values go into .tif or .asc, not into &apos;%1&apos;.</source>
        <translation>--relief: इसके मान .tif या .asc में जाते हैं, &apos;%1&apos; में नहीं।</translation>
    </message>
    <message>
        <source>--relief paints the whole map. Leave out --level and --region.</source>
        <translation>--relief पूरा मानचित्र रंगता है। --level और --region छोड़ दें।</translation>
    </message>
    <message>
        <source>%1: its ending is none of .tif, .asc, .vti, .ply, .xyz, .stl and .glb.</source>
        <translation>%1: इसका अंत .tif, .asc, .vti, .ply, .xyz, .stl और .glb में से नहीं है।</translation>
    </message>
    <message>
        <source>--light and --radius belong to --relief. Give it, or leave them out.</source>
        <translation>--light और --radius --relief के लिए हैं। उसे दें, या इन्हें छोड़ दें।</translation>
    </message>
    <message>
        <source>%1 needs x and y of {2|%2 place|%2 places}, not &apos;%3&apos;.</source>
        <translation>%1 को {2|%2 जगह|%2 जगहों} के x और y चाहिए, &apos;%3&apos; नहीं।</translation>
    </message>
    <message>
        <source>%1 needs x and y of at least {2|%2 place|%2 places}, not &apos;%3&apos;.</source>
        <translation>%1 को कम से कम {2|%2 जगह|%2 जगहों} के x और y चाहिए, &apos;%3&apos; नहीं।</translation>
    </message>
    <message>
        <source>There is nothing to measure. Give --point, --distance, --depth, --angle, --profile, --area or --section.</source>
        <translation>मापने को कुछ नहीं है। --point, --distance, --depth, --angle, --profile, --area या --section दें।</translation>
    </message>
    <message>
        <source>%1 is for one --%2; there are more.</source>
        <translation>%1 एक --%2 के लिए है; अधिक हैं।</translation>
    </message>
    <message>
        <source>%1 needs a --%2.</source>
        <translation>%1 को --%2 चाहिए।</translation>
    </message>
    <message>
        <source>%1: the file&apos;s name must end with %2, not &apos;%3&apos;. Nothing was written.</source>
        <translation>%1: फ़ाइल का नाम %2 पर समाप्त होना चाहिए, &apos;%3&apos; नहीं। कुछ नहीं लिखा गया।</translation>
    </message>
    <message>
        <source>There is nothing to plot: the stroke has no ticks.</source>
        <translation>बनाने को कुछ नहीं है: रेखा में कोई ताल नहीं है।</translation>
    </message>
    <message>
        <source>--stiffness must be above 0 N/mm.</source>
        <translation>--stiffness 0 N/mm से अधिक होना चाहिए।</translation>
    </message>
    <message>
        <source>--level-stiffness must be above 0 N/mm at every level.</source>
        <translation>--level-stiffness हर स्तर पर 0 N/mm से अधिक होना चाहिए।</translation>
    </message>
    <message>
        <source>--stiffness is one for all levels. Nothing was touched. Leave it out, or --level-stiffness.</source>
        <translation>--stiffness सभी स्तरों के लिए एक है। कुछ नहीं छुआ गया। इसे छोड़ दें, या --level-stiffness।</translation>
    </message>
    <message>
        <source>--friction: the paper&apos;s proxies know no friction; use --proxy converged.</source>
        <translation>--friction: लेख के प्रॉक्सी घर्षण नहीं जानते; --proxy converged काम में लें।</translation>
    </message>
    <message>
        <source>--friction must be 0 to %1, the static coefficient not below the dynamic one.</source>
        <translation>--friction 0 से %1 तक होना चाहिए, स्थैतिक गुणांक गतिक से कम नहीं।</translation>
    </message>
    <message>
        <source>--device: a stroke cannot move &apos;%1&apos;, which a person holds. Use virtual, or record without a stroke.</source>
        <translation>--device: रेखा &apos;%1&apos; को नहीं चला सकती, जिसे कोई पकड़े है। virtual काम में लें, या बिना रेखा के रिकॉर्ड करें।</translation>
    </message>
    <message>
        <source>--seconds must be above 0 and at most 86400.</source>
        <translation>--seconds 0 से अधिक और अधिकतम 86400 होना चाहिए।</translation>
    </message>
    <message>
        <source>--safety off is for a simulated hand, and a person holds the device &apos;%1&apos;. Nothing was recorded. Leave it out, or record with --device virtual.</source>
        <translation>--safety off कृत्रिम हाथ के लिए है, और उपकरण &apos;%1&apos; को कोई पकड़े है। कुछ रिकॉर्ड नहीं हुआ। इसे छोड़ दें, या --device virtual से रिकॉर्ड करें।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has the form of a boot image, but nobody knows this one (sha256 %2). Nothing was installed. Add --accept if you trust it.</source>
        <translation>&quot;%1&quot; का रूप बूट छवि का है, पर इसे कोई नहीं जानता (sha256 %2)। कुछ नहीं लगाया गया। भरोसा हो तो --accept जोड़ें।</translation>
    </message>
    <message>
        <source>--device: &apos;%1&apos; names no Falcon. Nothing was tried. Use an id of &apos;relievo devices&apos;.</source>
        <translation>--device: &apos;%1&apos; किसी Falcon का नाम नहीं है। कुछ नहीं आज़माया गया। &apos;relievo devices&apos; की कोई पहचान काम में लें।</translation>
    </message>
    <message>
        <source>The input ended before Enter said that the weight hangs. The old setting is kept. Run it at a terminal.</source>
        <translation>Enter के यह बताने से पहले कि भार लटका है, इनपुट समाप्त हो गया। पुरानी सेटिंग रहती है। इसे टर्मिनल पर चलाएँ।</translation>
    </message>
    <message>
        <source>The computer goes to sleep; the forces are off and this has ended. Begin again when it is awake.</source>
        <translation>कंप्यूटर सोने जा रहा है; बल बंद हैं और यह समाप्त हुआ। उसके जागने पर फिर शुरू करें।</translation>
    </message>
    <message>
        <source>The computer goes to sleep; the forces are off and this has ended. The old setting is kept. Begin again when it is awake.</source>
        <translation>कंप्यूटर सोने जा रहा है; बल बंद हैं और यह समाप्त हुआ। पुरानी सेटिंग रहती है। उसके जागने पर फिर शुरू करें।</translation>
    </message>
    <message>
        <source>%1 names &apos;%2&apos;, which lies outside of its folder and is not, by a checksum, what it was made from. It was not read, and nothing was made. %3 --outside-files allow reads it all the same.</source>
        <translation>%1 &apos;%2&apos; का नाम लेता है, जो उसके फ़ोल्डर के बाहर है और चेकसम से वह नहीं है जिससे यह बना। उसे नहीं पढ़ा गया, और कुछ नहीं बना। %3 --outside-files allow उसे फिर भी पढ़ता है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the file that %2 was made from (checksum differs, E501). Nothing was made. Give the right one as FILE, or --changed-input to use this one.</source>
        <translation>&apos;%1&apos; वह फ़ाइल नहीं है जिससे %2 बना (चेकसम अलग, E501)। कुछ नहीं बना। सही फ़ाइल FILE से दें, या इसे काम में लेने के लिए --changed-input।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the file that %2 was made for (checksum differs, E501). Nothing was done. Give the file by its name to use it all the same.</source>
        <translation>&apos;%1&apos; वह फ़ाइल नहीं है जिसके लिए %2 बना (चेकसम अलग, E501)। कुछ नहीं किया गया। इसे फिर भी काम में लेने के लिए फ़ाइल का नाम दें।</translation>
    </message>
    <message>
        <source>Recording stopped: disk full. {1|%1 sample is|%1 samples are} saved and complete in &quot;%2&quot;.</source>
        <translation>रिकॉर्डिंग रुकी: डिस्क भर गई। {1|%1 नमूना &quot;%2&quot; में सहेजा गया और पूरा है|%1 नमूने &quot;%2&quot; में सहेजे गए और पूरे हैं}।</translation>
    </message>
    <message>
        <source>Recording stopped: HDF5 could not write. {1|%1 sample is|%1 samples are} saved and complete in &quot;%2&quot;.</source>
        <translation>रिकॉर्डिंग रुकी: HDF5 लिख नहीं सका। {1|%1 नमूना &quot;%2&quot; में सहेजा गया और पूरा है|%1 नमूने &quot;%2&quot; में सहेजे गए और पूरे हैं}।</translation>
    </message>
    <message>
        <source>Recording stopped: %1. {2|%2 sample is|%2 samples are} saved and complete in &quot;%3&quot;.</source>
        <translation>रिकॉर्डिंग रुकी: %1। {2|%2 नमूना &quot;%3&quot; में सहेजा गया और पूरा है|%2 नमूने &quot;%3&quot; में सहेजे गए और पूरे हैं}।</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be written: disk full. Nothing was kept. Free some space or choose another place.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; नहीं लिखी जा सकती: डिस्क भरी है। कुछ नहीं रखा गया। जगह खाली करें या दूसरी जगह चुनें।</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be written: HDF5 refuses it. Choose another place.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; लिखी नहीं जा सकती: HDF5 मना करता है। दूसरी जगह चुनें।</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be written: %2. Choose another place.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; लिखी नहीं जा सकती: %2। दूसरी जगह चुनें।</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; may be incomplete.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; शायद अधूरी है।</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; may be incomplete: %2.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; शायद अधूरी है: %2।</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; is being written by another program. Nothing was recorded. Choose another name, or end the other one first.</source>
        <translation>रिकॉर्डिंग &quot;%1&quot; को अभी कोई दूसरा प्रोग्राम लिख रहा है। कुछ भी रिकॉर्ड नहीं हुआ। दूसरा नाम चुनें, या पहले दूसरी रिकॉर्डिंग समाप्त करें।</translation>
    </message>
    <message>
        <source>The recording is whole, but it cannot be called &quot;%1&quot;: %2. It is in &quot;%3&quot;.</source>
        <translation>रिकॉर्डिंग पूरी है, पर उसका नाम &quot;%1&quot; नहीं रखा जा सकता: %2। वह &quot;%3&quot; में है।</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; for recordings cannot be made. Nothing is recorded. Choose another one.</source>
        <translation>रिकॉर्डिंग का फ़ोल्डर &quot;%1&quot; नहीं बनाया जा सकता। कुछ रिकॉर्ड नहीं हो रहा। दूसरा चुनें।</translation>
    </message>
    <message>
        <source>no fault</source>
        <translation>कोई गड़बड़ी नहीं</translation>
    </message>
    <message>
        <source>the device did not answer in time</source>
        <translation>उपकरण ने समय पर उत्तर नहीं दिया</translation>
    </message>
    <message>
        <source>the device was unplugged</source>
        <translation>उपकरण निकाल दिया गया</translation>
    </message>
    <message>
        <source>the device sent something unreadable</source>
        <translation>उपकरण ने अपठनीय कुछ भेजा</translation>
    </message>
    <message>
        <source>the device is too hot</source>
        <translation>उपकरण बहुत गर्म है</translation>
    </message>
    <message>
        <source>the device reported an impossible position</source>
        <translation>उपकरण ने असंभव स्थिति बताई</translation>
    </message>
    <message>
        <source>the device is not ready yet</source>
        <translation>उपकरण अभी तैयार नहीं है</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>मापा हुआ</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>प्रक्षेपित</translation>
    </message>
    <message>
        <source>base plane</source>
        <translation>आधार तल</translation>
    </message>
    <message>
        <source>steep</source>
        <translation>खड़ा</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>बाहर</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>कुछ नहीं</translation>
    </message>
    <message>
        <source>Whole object</source>
        <translation>पूरी वस्तु</translation>
    </message>
    <message>
        <source>Where am I</source>
        <translation>मैं कहाँ हूँ</translation>
    </message>
    <message>
        <source>Where am I, in full</source>
        <translation>मैं कहाँ हूँ, पूरा</translation>
    </message>
    <message>
        <source>Forces on or off</source>
        <translation>बल चालू या बंद</translation>
    </message>
    <message>
        <source>Forces off</source>
        <translation>बल बंद</translation>
    </message>
    <message>
        <source>Move mode</source>
        <translation>खिसकाने की विधा</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>खिसकाया</translation>
    </message>
    <message>
        <source>Back to the old window</source>
        <translation>पुरानी विंडो पर वापस</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>बाएँ</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>दाएँ</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>ऊपर</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>नीचे</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>सहायता</translation>
    </message>
    <message>
        <source>Introduction</source>
        <translation>परिचय</translation>
    </message>
    <message>
        <source>The Falcon is not in use.</source>
        <translation>Falcon उपयोग में नहीं है।</translation>
    </message>
    <message>
        <source>Falcon unplugged. Forces off. View and recording go on. Plug it in again, or choose the mouse as the device.</source>
        <translation>Falcon निकाल दिया गया। बल बंद। दृश्य और रिकॉर्डिंग चलते रहते हैं। उसे फिर जोड़ें, या उपकरण के रूप में माउस चुनें।</translation>
    </message>
    <message>
        <source>Falcon unplugged. Forces are off.</source>
        <translation>Falcon निकाल दिया गया। बल बंद हैं।</translation>
    </message>
    <message>
        <source>Falcon unplugged. Forces off. View and recording go on. Plug it in again. There is also %1, which is not used in its place unless you choose it.</source>
        <translation>Falcon निकाल दिया गया। बल बंद। दृश्य और रिकॉर्डिंग चलती रहती हैं। उसे फिर लगाएँ। %1 भी लगा है, पर जब तक आप उसे न चुनें वह उसकी जगह काम में नहीं लिया जाता।</translation>
    </message>
    <message>
        <source>No Falcon is plugged in. Plug in its power supply, then its USB cable.</source>
        <translation>कोई Falcon नहीं लगा है। पहले उसकी बिजली की आपूर्ति जोड़ें, फिर उसका USB केबल।</translation>
    </message>
    <message>
        <source>No Falcon is plugged in.</source>
        <translation>कोई Falcon नहीं लगा है।</translation>
    </message>
    <message>
        <source>%1 was chosen and is not plugged in. Plug in its power supply, then its USB cable.</source>
        <translation>%1 चुना गया था और लगा नहीं है। पहले उसका पावर अडैप्टर लगाएँ, फिर उसकी USB केबल।</translation>
    </message>
    <message>
        <source>The chosen Falcon is not plugged in.</source>
        <translation>चुना हुआ Falcon लगा नहीं है।</translation>
    </message>
    <message>
        <source>%1 was chosen and is not plugged in. There is %2, which is not used in its place unless you choose it.</source>
        <translation>%1 चुना गया था और लगा नहीं है। %2 लगा है, पर जब तक आप उसे न चुनें वह उसकी जगह काम में नहीं लिया जाता।</translation>
    </message>
    <message>
        <source>Several Falcons are plugged in: %1. None is used until you choose one.</source>
        <translation>कई Falcon लगे हैं: %1। जब तक आप एक न चुनें कोई काम में नहीं लिया जाता।</translation>
    </message>
    <message>
        <source>Several Falcons are plugged in. Choose one.</source>
        <translation>कई Falcon लगे हैं। एक चुनें।</translation>
    </message>
    <message>
        <source>A Falcon is plugged in but this account may not use it. Install the rule that the device set-up shows and &apos;relievo devices rule&apos; prints, once (needs an administrator), then replug.</source>
        <translation>एक Falcon लगा है, पर इस खाते को उसके उपयोग की अनुमति नहीं है। उपकरण की तैयारी जो नियम दिखाती है और &apos;relievo devices rule&apos; जो छापता है, उसे एक बार स्थापित करें (प्रशासक चाहिए), फिर दोबारा जोड़ें।</translation>
    </message>
    <message>
        <source>Falcon found, but not allowed. Ask staff.</source>
        <translation>Falcon मिला, पर अनुमति नहीं है। कर्मचारियों से पूछें।</translation>
    </message>
    <message>
        <source>Another program is using the Falcon. Close it, then try again.</source>
        <translation>कोई दूसरा प्रोग्राम Falcon का उपयोग कर रहा है। उसे बंद करें, फिर कोशिश करें।</translation>
    </message>
    <message>
        <source>The Falcon is busy.</source>
        <translation>Falcon व्यस्त है।</translation>
    </message>
    <message>
        <source>The Falcon could not be opened: %1. Replug it, or try another port.</source>
        <translation>Falcon खोला नहीं जा सका: %1। उसे दोबारा जोड़ें, या दूसरा पोर्ट आज़माएँ।</translation>
    </message>
    <message>
        <source>The Falcon could not be opened.</source>
        <translation>Falcon खोला नहीं जा सका।</translation>
    </message>
    <message>
        <source>USB cannot be used</source>
        <translation>USB का उपयोग नहीं हो सकता</translation>
    </message>
    <message>
        <source>Asking the Falcon whether it is ready.</source>
        <translation>Falcon से पूछा जा रहा है कि वह तैयार है या नहीं।</translation>
    </message>
    <message>
        <source>Falcon found.</source>
        <translation>Falcon मिला।</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware file.</source>
        <translation>Falcon को उसकी फ़र्मवेयर फ़ाइल चाहिए।</translation>
    </message>
    <message>
        <source>Starting the Falcon – attempt %1 of %2. This is normal.</source>
        <translation>Falcon शुरू हो रहा है – प्रयास %2 में से %1। यह सामान्य है।</translation>
    </message>
    <message>
        <source>Starting the Falcon.</source>
        <translation>Falcon शुरू हो रहा है।</translation>
    </message>
    <message>
        <source>Still starting.</source>
        <translation>अब भी शुरू हो रहा है।</translation>
    </message>
    <message>
        <source>The connection to the Falcon failed {1|%1 time|%1 times}, although it is plugged in. Forces are off; it is tried again every 10 seconds. Plug it straight into the computer, if you can with another cable, or choose Touch &gt; Device set-up &gt; Retry.</source>
        <translation>Falcon जुड़ा है, फिर भी उससे संपर्क %1 बार विफल हुआ। बल बंद हैं; हर 10 सेकंड में फिर कोशिश होती है। इसे सीधे कंप्यूटर में लगाएँ, हो सके तो दूसरी केबल से, या स्पर्श &gt; डिवाइस सेटअप &gt; फिर कोशिश चुनें।</translation>
    </message>
    <message>
        <source>The Falcon does not answer. Forces are off.</source>
        <translation>Falcon उत्तर नहीं देता। बल बंद हैं।</translation>
    </message>
    <message>
        <source>The Falcon did not start after {1|%1 attempt|%1 attempts}; it is left alone now. Check its power supply and plug it straight into the computer, or choose Touch &gt; Device set-up &gt; Retry.</source>
        <translation>Falcon {1|%1 प्रयास|%1 प्रयासों} के बाद भी शुरू नहीं हुआ; अब उसे छोड़ दिया गया है। उसकी बिजली की आपूर्ति जाँचें और उसे सीधे कंप्यूटर से जोड़ें, या स्पर्श &gt; उपकरण की तैयारी &gt; फिर कोशिश चुनें।</translation>
    </message>
    <message>
        <source>The Falcon did not start. You can continue with the mouse.</source>
        <translation>Falcon शुरू नहीं हुआ। आप माउस से आगे बढ़ सकते हैं।</translation>
    </message>
    <message>
        <source>The Falcon did not start after {1|%1 attempt|%1 attempts}; it is left alone now. Check its power supply and plug it straight into the computer, or choose Touch &gt; Device set-up &gt; Retry. (%2)</source>
        <translation>Falcon {1|%1 प्रयास|%1 प्रयासों} के बाद भी शुरू नहीं हुआ; अब उसे छोड़ दिया गया है। उसकी बिजली की आपूर्ति जाँचें और उसे सीधे कंप्यूटर से जोड़ें, या स्पर्श &gt; उपकरण की तैयारी &gt; फिर कोशिश चुनें। (%2)</translation>
    </message>
    <message>
        <source>its boot loader did not answer</source>
        <translation>उसके बूट लोडर ने उत्तर नहीं दिया</translation>
    </message>
    <message>
        <source>it did not lock on to the baud rate</source>
        <translation>वह बॉड दर नहीं पकड़ सका</translation>
    </message>
    <message>
        <source>it echoed wrongly after byte %1 of %2</source>
        <translation>%2 में से बाइट %1 के बाद उसकी प्रतिध्वनि गलत थी</translation>
    </message>
    <message>
        <source>it did not run after loading</source>
        <translation>लोड होने के बाद वह नहीं चला</translation>
    </message>
    <message>
        <source>Please pull the grip fully out, then push it fully in. Still missing: %1.</source>
        <translation>कृपया ग्रिप को पूरा बाहर खींचें, फिर पूरा अंदर धकेलें। ये भुजाएँ अभी नहीं मिलीं: %1।</translation>
    </message>
    <message>
        <source>Please pull the grip fully out, then push it fully in.</source>
        <translation>कृपया ग्रिप को पूरा बाहर खींचें, फिर पूरा अंदर धकेलें।</translation>
    </message>
    <message>
        <source>Please pull the grip fully out, then push it fully in. Still missing: %1. It takes long: pull straight out, push straight in, as far as it goes; do not twist.</source>
        <translation>कृपया ग्रिप को पूरा बाहर खींचें, फिर पूरा अंदर धकेलें। ये भुजाएँ अभी नहीं मिलीं: %1। इसमें देर लग रही है: सीधा बाहर खींचें, सीधा अंदर धकेलें, जहाँ तक जाए; घुमाएँ नहीं।</translation>
    </message>
    <message>
        <source>Straight out, straight in; do not twist the grip.</source>
        <translation>सीधा बाहर, सीधा अंदर; ग्रिप को न घुमाएँ।</translation>
    </message>
    <message>
        <source>All three arms have found their place. Pull the grip fully out once more.</source>
        <translation>तीनों भुजाओं को उनकी जगह मिल गई। ग्रिप को एक बार और पूरा बाहर खींचें।</translation>
    </message>
    <message>
        <source>Pull the grip fully out.</source>
        <translation>ग्रिप को पूरा बाहर खींचें।</translation>
    </message>
    <message>
        <source>Falcon ready.</source>
        <translation>Falcon तैयार है।</translation>
    </message>
    <message>
        <source>The connection to the Falcon fails, although it is plugged in. Forces are off; it is opened anew – %1 of %2.</source>
        <translation>Falcon जुड़ा है, फिर भी उससे संपर्क विफल हो रहा है। बल बंद हैं; इसे फिर से खोला जा रहा है – %2 में से %1।</translation>
    </message>
    <message>
        <source>The Falcon does not answer. Forces are off; trying to wake it.</source>
        <translation>Falcon उत्तर नहीं देता। बल बंद हैं; उसे जगाने की कोशिश हो रही है।</translation>
    </message>
    <message>
        <source>top</source>
        <translation>ऊपरी</translation>
    </message>
    <message>
        <source>right</source>
        <translation>दाईं</translation>
    </message>
    <message>
        <source>left</source>
        <translation>बाईं</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>प्लस</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>आगे</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>बीच</translation>
    </message>
    <message>
        <source>minus</source>
        <translation>माइनस</translation>
    </message>
    <message>
        <source>USB cannot be used: %1.</source>
        <translation>USB का उपयोग नहीं हो सकता: %1।</translation>
    </message>
    <message>
        <source>The Falcon&apos;s thread could not be started: %1.</source>
        <translation>Falcon का थ्रेड शुरू नहीं हो सका: %1।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no Falcon. Write falcon:SERIAL, falcon:SERIAL@PORT or falcon:@PORT as &apos;relievo devices&apos; lists them, or falcon for the only one.</source>
        <translation>&quot;%1&quot; किसी Falcon का नाम नहीं है। falcon:SERIAL, falcon:SERIAL@PORT या falcon:@PORT लिखें, जैसा &apos;relievo devices&apos; बताता है, या एकमात्र के लिए falcon।</translation>
    </message>
    <message>
        <source>There is no mouse device named &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; नाम का कोई माउस उपकरण नहीं है।</translation>
    </message>
    <message>
        <source>There is no device &quot;%1&quot;. This build knows: %2.</source>
        <translation>&quot;%1&quot; नाम का कोई उपकरण नहीं है। यह प्रोग्राम जानता है: %2।</translation>
    </message>
    <message>
        <source>HID devices cannot be used on this system.</source>
        <translation>इस सिस्टम पर HID उपकरण काम में नहीं लिए जा सकते।</translation>
    </message>
    <message>
        <source>There is no virtual hand &quot;%1&quot;. Known: %2.</source>
        <translation>&quot;%1&quot; नाम का कोई आभासी हाथ नहीं है। जाने हुए: %2।</translation>
    </message>
    <message>
        <source>The virtual hand&apos;s delay is {1|%1 tick|%1 ticks}; 0, 1 and 2 are possible.</source>
        <translation>आभासी हाथ की देरी %1 ताल है; 0, 1 और 2 संभव हैं।</translation>
    </message>
    <message>
        <source>A scripted device needs at least one reading.</source>
        <translation>लिपिबद्ध उपकरण को कम से कम एक पाठ्यांक चाहिए।</translation>
    </message>
    <message>
        <source>The test ended early: %1. %2</source>
        <translation>जाँच समय से पहले रुक गई: %1। %2</translation>
    </message>
    <message>
        <source>Rate: %1 answers per second (%2 are needed).</source>
        <translation>दर: प्रति सेकंड %1 उत्तर (%2 चाहिए)।</translation>
    </message>
    <message>
        <source>Line: {1|%1 damaged answer|%1 damaged answers}, {2|%2 stall|%2 stalls}, {3|%3 overrun|%3 overruns}.</source>
        <translation>लाइन: %1 क्षतिग्रस्त उत्तर, {2|%2 रुकावट|%2 रुकावटें}, %3 अतिप्रवाह।</translation>
    </message>
    <message>
        <source>Times from answer to answer: up to 0.8 ms %1, up to 1.0 ms %2, up to 1.2 ms %3, up to 2.0 ms %4, up to 5.0 ms %5, up to 20.0 ms %6, up to 100.0 ms %7, above 100.0 ms %8; the longest %9 ms.</source>
        <translation>उत्तर से उत्तर तक का समय: 0.8 ms तक %1, 1.0 ms तक %2, 1.2 ms तक %3, 2.0 ms तक %4, 5.0 ms तक %5, 20.0 ms तक %6, 100.0 ms तक %7, 100.0 ms से ऊपर %8; सबसे लंबा %9 ms।</translation>
    </message>
    <message>
        <source>From question to answer: %1 ms on average, %2 ms at worst.</source>
        <translation>प्रश्न से उत्तर तक: औसतन %1 ms, अधिकतम %2 ms।</translation>
    </message>
    <message>
        <source>Lights: red, green and blue were shown one after the other.</source>
        <translation>बत्तियाँ: लाल, हरी और नीली एक के बाद एक दिखाई गईं।</translation>
    </message>
    <message>
        <source>Nudges of 0.5 N moved the hand by right %1 mm, left %2 mm, up %3 mm, down %4 mm, out %5 mm, in %6 mm.</source>
        <translation>0.5 N के धक्कों से हाथ इतना हिला: दाएँ %1 mm, बाएँ %2 mm, ऊपर %3 mm, नीचे %4 mm, बाहर %5 mm, अंदर %6 mm।</translation>
    </message>
    <message>
        <source>Nudges of 0.5 N moved the hand by right %1 mm, left %2 mm, up %3 mm, down %4 mm, out %5 mm, in %6 mm; a hand that holds on moves less.</source>
        <translation>0.5 N के धक्कों से हाथ इतना हिला: दाएँ %1 mm, बाएँ %2 mm, ऊपर %3 mm, नीचे %4 mm, बाहर %5 mm, अंदर %6 mm; कसकर पकड़ा हाथ कम हिलता है।</translation>
    </message>
    <message>
        <source>Nudges of 0.5 N moved the hand by right %1 mm, left %2 mm, up %3 mm, down %4 mm, out %5 mm, in %6 mm; the motors moved nothing. Check the Falcon&apos;s power supply, hold the grip loosely or let go of it, and test again.</source>
        <translation>0.5 N के धक्कों से हाथ दाएँ %1 mm, बाएँ %2 mm, ऊपर %3 mm, नीचे %4 mm, बाहर %5 mm, भीतर %6 mm हिला; मोटरों ने कुछ नहीं हिलाया। Falcon की बिजली जाँचें, ग्रिप को ढीला पकड़ें या छोड़ दें, और फिर से जाँचें।</translation>
    </message>
    <message>
        <source>Buttons: all four work.</source>
        <translation>बटन: चारों काम करते हैं।</translation>
    </message>
    <message>
        <source>Buttons that were not pressed: %1.</source>
        <translation>बटन जो नहीं दबाए गए: %1।</translation>
    </message>
    <message>
        <source>Encoder of the %1 arm: moved by {2|%2 count|%2 counts}.</source>
        <translation>%1 भुजा का एनकोडर: %2 गणना चला।</translation>
    </message>
    <message>
        <source>Measuring how evenly the Falcon answers.</source>
        <translation>मापा जा रहा है कि Falcon कितनी नियमितता से उत्तर देता है।</translation>
    </message>
    <message>
        <source>Watch the lights: red, green, blue.</source>
        <translation>बत्तियाँ देखें: लाल, हरी, नीली।</translation>
    </message>
    <message>
        <source>Hold the grip loosely: six small nudges of half a newton.</source>
        <translation>ग्रिप को ढीला पकड़ें: आधे न्यूटन के छह छोटे धक्के।</translation>
    </message>
    <message>
        <source>The self test passed.</source>
        <translation>स्व-जाँच सफल रही।</translation>
    </message>
    <message>
        <source>The self test found something wrong.</source>
        <translation>स्व-जाँच में कुछ गड़बड़ मिली।</translation>
    </message>
    <message>
        <source>The weight must be 20 to 300 grams.</source>
        <translation>भार 20 से 300 ग्राम होना चाहिए।</translation>
    </message>
    <message>
        <source>Take your hand off the grip. The Falcon holds it in place.</source>
        <translation>ग्रिप से हाथ हटाएँ। Falcon उसे उसकी जगह पर रोके रखता है।</translation>
    </message>
    <message>
        <source>Hang the weight on the grip, let it come to rest, then press Continue.</source>
        <translation>भार को ग्रिप पर लटकाएँ, उसे स्थिर होने दें, फिर “जारी रखें” दबाएँ।</translation>
    </message>
    <message>
        <source>Holding the weight. Do not touch it.</source>
        <translation>भार को थामा जा रहा है। उसे न छुएँ।</translation>
    </message>
    <message>
        <source>The force is calibrated.</source>
        <translation>बल का अंशांकन हो गया।</translation>
    </message>
    <message>
        <source>The calibration ended: %1. The old setting is kept.</source>
        <translation>अंशांकन रुक गया: %1। पुरानी सेटिंग बनी रहती है।</translation>
    </message>
    <message>
        <source>the grip did not come to rest</source>
        <translation>ग्रिप स्थिर नहीं हुई</translation>
    </message>
    <message>
        <source>the Falcon or this computer was interrupted too often to measure a force</source>
        <translation>Falcon या यह कंप्यूटर इतनी बार रुका कि बल मापा नहीं जा सका</translation>
    </message>
    <message>
        <source>the weight seemed to be %1 g, which no Falcon&apos;s motors explain (is it the right one, and hanging free?)</source>
        <translation>भार %1 g जान पड़ा, जो किसी Falcon की मोटरों से संभव नहीं (क्या वही भार है, और खुला लटका है?)</translation>
    </message>
    <message>
        <source>The hash of the firmware could not be computed. Nothing was loaded. Check that OpenSSL&apos;s library is whole and allows SHA-256.</source>
        <translation>फ़र्मवेयर का हैश नहीं निकाला जा सका। कुछ नहीं लोड हुआ। जाँचें कि OpenSSL की लाइब्रेरी पूरी है और SHA-256 की अनुमति देती है।</translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;. Nothing was loaded. Check its name.</source>
        <translation>फ़ाइल &quot;%1&quot; नहीं है। कुछ नहीं लोड हुआ। उसका नाम जाँचें।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read: %2. Nothing was loaded. Check its permissions and its folder&apos;s.</source>
        <translation>&quot;%1&quot; पढ़ी नहीं जा सकती: %2। कुछ नहीं लोड हुआ। उसकी और उसके फ़ोल्डर की अनुमति जाँचें।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a regular file; it was not read as Falcon firmware. Name the file itself, such as nvent_firmware.bin.</source>
        <translation>&quot;%1&quot; साधारण फ़ाइल नहीं है; उसे Falcon फ़र्मवेयर के रूप में नहीं पढ़ा गया। फ़ाइल का ही नाम दें, जैसे nvent_firmware.bin।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Falcon firmware: it has more than %2 bytes. Nothing was loaded. Choose another file.</source>
        <translation>&quot;%1&quot; Falcon फ़र्मवेयर नहीं है: इसमें %2 से अधिक बाइट हैं। कुछ नहीं लोड हुआ। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read to its end. Nothing was loaded. Copy it to another disk, or choose another file.</source>
        <translation>&quot;%1&quot; अंत तक पढ़ी नहीं जा सकी। कुछ नहीं लोड हुआ। उसे दूसरी डिस्क पर कॉपी करें, या दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Falcon firmware: %2. Nothing was loaded. Choose another file.</source>
        <translation>&quot;%1&quot; Falcon फ़र्मवेयर नहीं है: %2। कुछ नहीं लोड हुआ। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>it has {1|%1 byte|%1 bytes}; 2048 to 65536 are possible</source>
        <translation>इसमें %1 बाइट हैं; 2048 से 65536 संभव हैं</translation>
    </message>
    <message>
        <source>its length is odd</source>
        <translation>इसकी लंबाई विषम है</translation>
    </message>
    <message>
        <source>it does not begin with AA 08</source>
        <translation>यह AA 08 से शुरू नहीं होती</translation>
    </message>
    <message>
        <source>it ends before its entry point</source>
        <translation>यह अपने प्रवेश बिंदु से पहले समाप्त होती है</translation>
    </message>
    <message>
        <source>it ends in block %1</source>
        <translation>यह खंड %1 में समाप्त होती है</translation>
    </message>
    <message>
        <source>{1|%1 byte follows|%1 bytes follow} its last block</source>
        <translation>इसके अंतिम खंड के बाद %1 बाइट हैं</translation>
    </message>
    <message>
        <source>it has no blocks</source>
        <translation>इसमें कोई खंड नहीं है</translation>
    </message>
    <message>
        <source>%1 (recommended)</source>
        <translation>%1 (अनुशंसित)</translation>
    </message>
    <message>
        <source>the setting Falcon firmware (Preferences &gt; Device)</source>
        <translation>सेटिंग Falcon फ़र्मवेयर (वरीयताएँ &gt; उपकरण)</translation>
    </message>
    <message>
        <source>The Falcon firmware &quot;%1&quot; that %2 names does not exist. Nothing was loaded. Correct %2, or clear it to search the usual places.</source>
        <translation>Falcon फ़र्मवेयर &quot;%1&quot; नहीं है; उसका नाम यहाँ है: %2। कुछ नहीं लोड हुआ। ठीक करें: %2, या सामान्य जगहों में खोजने के लिए उसे खाली करें।</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; that %2 names has no Falcon firmware (such as nvent_firmware.bin). Nothing was loaded. Correct %2, or clear it to search the usual places.</source>
        <translation>फ़ोल्डर &quot;%1&quot; में Falcon फ़र्मवेयर (जैसे nvent_firmware.bin) नहीं है; उसका नाम यहाँ है: %2। कुछ नहीं लोड हुआ। ठीक करें: %2, या सामान्य जगहों में खोजने के लिए उसे खाली करें।</translation>
    </message>
    <message>
        <source>%1 It is what %2 names. Correct %2, or clear it to search the usual places.</source>
        <translation>%1 उसका नाम यहाँ है: %2। ठीक करें: %2, या सामान्य जगहों में खोजने के लिए उसे खाली करें।</translation>
    </message>
    <message>
        <source>The Falcon is connected but has no firmware loaded. relievo cannot include Novint&apos;s firmware. Run &apos;relievo devices firmware FILE&apos; with the file nvent_firmware.bin (8492 bytes) from your Novint software or libnifalcon, or set RELIEVO_FALCON_FIRMWARE. Places searched: %1.</source>
        <translation>Falcon जुड़ा है पर उसमें फ़र्मवेयर लोड नहीं है। relievo में Novint का फ़र्मवेयर शामिल नहीं किया जा सकता। अपने Novint सॉफ़्टवेयर या libnifalcon की फ़ाइल nvent_firmware.bin (8492 बाइट) के साथ &apos;relievo devices firmware FILE&apos; चलाएँ, या RELIEVO_FALCON_FIRMWARE रखें। खोजी गई जगहें: %1।</translation>
    </message>
    <message>
        <source>The Falcon firmware &quot;%1&quot; has the form of a boot image, but nobody knows this one (sha256 %2); it was not loaded. If you trust it, run &apos;relievo devices firmware FILE --accept&apos; once.</source>
        <translation>Falcon फ़र्मवेयर &quot;%1&quot; बूट इमेज के रूप का है, पर इसे कोई नहीं जानता (sha256 %2); उसे लोड नहीं किया गया। यदि आपको उस पर भरोसा है, तो एक बार &apos;relievo devices firmware FILE --accept&apos; चलाएँ।</translation>
    </message>
    <message>
        <source>The firmware could not be copied to &quot;%1&quot;: %2. Nothing was changed. Check the folder and the disk&apos;s room.</source>
        <translation>फ़र्मवेयर की प्रति &quot;%1&quot; में नहीं बन सकी: %2। कुछ नहीं बदला। फ़ोल्डर और डिस्क की खाली जगह जाँचें।</translation>
    </message>
    <message>
        <source>The Falcon&apos;s settings could not be written to &quot;%1&quot;. They hold until the program ends. Check the folder&apos;s permissions.</source>
        <translation>Falcon की सेटिंग &quot;%1&quot; में लिखी नहीं जा सकीं। वे प्रोग्राम के बंद होने तक लागू हैं। फ़ोल्डर की अनुमति जाँचें।</translation>
    </message>
    <message>
        <source>The haptic loop needs a device.</source>
        <translation>हैप्टिक लूप को उपकरण चाहिए।</translation>
    </message>
    <message>
        <source>A device that a person holds never gets the bare spring.</source>
        <translation>जिस उपकरण को कोई पकड़े हो उसे कोरी स्प्रिंग कभी नहीं मिलती।</translation>
    </message>
    <message>
        <source>The haptic loop&apos;s period must be above 0 ns.</source>
        <translation>हैप्टिक लूप की अवधि 0 ns से अधिक होनी चाहिए।</translation>
    </message>
    <message>
        <source>The window has %1 samples; the haptic space holds exactly 200 x 200.</source>
        <translation>खिड़की में %1 नमूने हैं; हैप्टिक स्थान में ठीक 200 x 200 आते हैं।</translation>
    </message>
    <message>
        <source>The window has a height that is not a finite number; nothing can be felt.</source>
        <translation>खिड़की में एक ऊँचाई परिमित संख्या नहीं है; कुछ महसूस नहीं हो सकता।</translation>
    </message>
    <message>
        <source>The window&apos;s side is %1 mm; it must be greater than 0.</source>
        <translation>खिड़की की भुजा %1 mm है; वह 0 से अधिक होनी चाहिए।</translation>
    </message>
    <message>
        <source>A texture has %1 heights; exactly 400 x 400 finite ones are needed.</source>
        <translation>एक बनावट में %1 ऊँचाइयाँ हैं; ठीक 400 x 400 परिमित चाहिए।</translation>
    </message>
    <message>
        <source>This recording cannot be replayed: %1.</source>
        <translation>यह रिकॉर्डिंग दोहराई नहीं जा सकती: %1।</translation>
    </message>
    <message>
        <source>This recording cannot be replayed: samples were dropped before tick %1.</source>
        <translation>यह रिकॉर्डिंग दोहराई नहीं जा सकती: ताल %1 से पहले नमूने छूट गए।</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; cannot be read.</source>
        <translation>रेखा &quot;%1&quot; पढ़ी नहीं जा सकती।</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; cannot be read to its end.</source>
        <translation>रेखा &quot;%1&quot; अंत तक पढ़ी नहीं जा सकती।</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; does not start with the line %2.</source>
        <translation>रेखा &quot;%1&quot; पंक्ति %2 से शुरू नहीं होती।</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; row %2 %3.</source>
        <translation>रेखा &quot;%1&quot; पंक्ति %2: %3।</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; row %2 is not later than the row before it; times must increase.</source>
        <translation>रेखा &quot;%1&quot; पंक्ति %2 पिछली पंक्ति के बाद की नहीं है; समय बढ़ने चाहिए।</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; has no rows.</source>
        <translation>रेखा &quot;%1&quot; में कोई पंक्ति नहीं है।</translation>
    </message>
    <message>
        <source>The stroke lasts %1 s; are its times in seconds?</source>
        <translation>रेखा %1 s चलती है; क्या इसके समय सेकंड में हैं?</translation>
    </message>
    <message>
        <source>A stroke needs at least one point.</source>
        <translation>रेखा को कम से कम एक बिंदु चाहिए।</translation>
    </message>
    <message>
        <source>The stiffness must be a finite number of N/mm above 0.</source>
        <translation>कठोरता 0 से अधिक N/mm की परिमित संख्या होनी चाहिए।</translation>
    </message>
    <message>
        <source>The damping must be a finite number of N s/mm, 0 or above.</source>
        <translation>अवमंदन 0 या अधिक N s/mm की परिमित संख्या होना चाहिए।</translation>
    </message>
    <message>
        <source>No cell of the grid was hit by the scan. Nothing was made. Choose another view.</source>
        <translation>स्कैन ग्रिड के किसी खाने पर नहीं पड़ा। कुछ नहीं बना। दूसरा दृश्य चुनें।</translation>
    </message>
    <message>
        <source>A free view needs its rotation.</source>
        <translation>मुक्त दृश्य को उसका घुमाव चाहिए।</translation>
    </message>
    <message>
        <source>There is no view &apos;%1&apos;. Choose front, back, left, right, top, bottom, auto, fit or axes.</source>
        <translation>&apos;%1&apos; नाम का कोई दृश्य नहीं है। front, back, left, right, top, bottom, auto, fit या axes चुनें।</translation>
    </message>
    <message>
        <source>A view is turned by finite numbers of degrees.</source>
        <translation>दृश्य को परिमित अंशों से घुमाया जाता है।</translation>
    </message>
    <message>
        <source>A point is not finite.</source>
        <translation>एक बिंदु परिमित नहीं है।</translation>
    </message>
    <message>
        <source>At least one neighbour must be asked for.</source>
        <translation>कम से कम एक पड़ोसी माँगना होगा।</translation>
    </message>
    <message>
        <source>%1 is no recipe that this version can read. %2 Nothing was done.</source>
        <translation>%1 ऐसी विधि नहीं है जिसे यह संस्करण पढ़ सके। %2 कुछ नहीं किया गया।</translation>
    </message>
    <message>
        <source>Line %1 of it is not JSON.</source>
        <translation>इसकी पंक्ति %1 JSON नहीं है।</translation>
    </message>
    <message>
        <source>A number in it is too large.</source>
        <translation>इसमें एक संख्या बहुत बड़ी है।</translation>
    </message>
    <message>
        <source>There is no &apos;%1&apos; where one belongs.</source>
        <translation>जहाँ &apos;%1&apos; होना चाहिए वहाँ वह नहीं है।</translation>
    </message>
    <message>
        <source>A part of it is missing or has another form.</source>
        <translation>इसका एक भाग नहीं है या उसका रूप दूसरा है।</translation>
    </message>
    <message>
        <source>A part of it is no object.</source>
        <translation>इसका एक भाग ऑब्जेक्ट नहीं है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a key that is known there.</source>
        <translation>&apos;%1&apos; वहाँ कोई जानी हुई कुंजी नहीं है।</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 संख्या नहीं है।</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0 to 4294967295.</source>
        <translation>%1 0 से 4294967295 तक की पूर्ण संख्या नहीं है।</translation>
    </message>
    <message>
        <source>A list of it has not %1 numbers.</source>
        <translation>इसकी एक सूची में %1 संख्याएँ नहीं हैं।</translation>
    </message>
    <message>
        <source>%1 is none of the six standard views.</source>
        <translation>%1 छह मानक दृश्यों में से नहीं है।</translation>
    </message>
    <message>
        <source>&apos;keep&apos; is neither inside nor outside.</source>
        <translation>&apos;keep&apos; न inside है न outside।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no list of at most %2 entries.</source>
        <translation>&apos;%1&apos; अधिक से अधिक %2 प्रविष्टियों की सूची नहीं है।</translation>
    </message>
    <message>
        <source>A class is from 0 to 255.</source>
        <translation>वर्ग 0 से 255 तक होता है।</translation>
    </message>
    <message>
        <source>&apos;keep&apos; is none of first, last and single.</source>
        <translation>&apos;keep&apos; first, last और single में से कोई नहीं है।</translation>
    </message>
    <message>
        <source>&apos;method&apos; is none of stored, points and auto.</source>
        <translation>&apos;method&apos; stored, points और auto में से कोई नहीं है।</translation>
    </message>
    <message>
        <source>A step is no object.</source>
        <translation>एक चरण ऑब्जेक्ट नहीं है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no step that is known.</source>
        <translation>&apos;%1&apos; कोई जाना हुआ चरण नहीं है।</translation>
    </message>
    <message>
        <source>&apos;unit&apos; is none of mm, cm, m, in, ft and us-ft.</source>
        <translation>&apos;unit&apos; mm, cm, m, in, ft और us-ft में से कोई नहीं है।</translation>
    </message>
    <message>
        <source>&apos;parts&apos; are not numbers of a file&apos;s scans, from 1.</source>
        <translation>&apos;parts&apos; फ़ाइल के स्कैनों के क्रमांक, 1 से, नहीं हैं।</translation>
    </message>
    <message>
        <source>Its schema is %1; this version reads 1.</source>
        <translation>इसका स्कीमा %1 है; यह संस्करण 1 पढ़ता है।</translation>
    </message>
    <message>
        <source>The recipe names %1 scans; at most %2 can be prepared at once.</source>
        <translation>विधि में %1 स्कैन हैं; एक साथ अधिक से अधिक %2 तैयार किए जा सकते हैं।</translation>
    </message>
    <message>
        <source>The recipe has %1 steps; at most %2 can be done at once.</source>
        <translation>विधि में %1 चरण हैं; एक साथ अधिक से अधिक %2 किए जा सकते हैं।</translation>
    </message>
    <message>
        <source>The recipe aligns its scans twice. Leave one step out.</source>
        <translation>विधि अपने स्कैनों को दो बार संरेखित करती है। एक चरण छोड़ दें।</translation>
    </message>
    <message>
        <source>The recipe is for {1|%1 scan|%1 scans}, but there are %2. Nothing was done.</source>
        <translation>विधि %1 स्कैनों के लिए है, पर %2 हैं। कुछ नहीं किया गया।</translation>
    </message>
    <message>
        <source>The recipe has poses for {1|%1 scan|%1 scans}, but there are %2. Nothing was done. Give the scans that it was made for.</source>
        <translation>विधि में %1 स्कैनों की स्थितियाँ हैं, पर %2 हैं। कुछ नहीं किया गया। वही स्कैन दें जिनके लिए यह बनी थी।</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2।</translation>
    </message>
    <message>
        <source>Step %1 (%2)</source>
        <translation>चरण %1 (%2)</translation>
    </message>
    <message>
        <source>the box ends before it begins; its first corner must be the lower one</source>
        <translation>डिब्बा शुरू होने से पहले समाप्त होता है; उसका पहला कोना नीचे वाला होना चाहिए</translation>
    </message>
    <message>
        <source>the outline has {1|%1 corner|%1 corners}; it takes 3 to %2</source>
        <translation>रूपरेखा में {1|%1 कोना है|%1 कोने हैं}; 3 से %2 चाहिए</translation>
    </message>
    <message>
        <source>the highest intensity is below the lowest</source>
        <translation>सबसे ऊँची तीव्रता सबसे नीची से कम है</translation>
    </message>
    <message>
        <source>&apos;reference&apos; is beyond the scans there can be</source>
        <translation>&apos;reference&apos; संभव स्कैनों से परे है</translation>
    </message>
    <message>
        <source>it has more than %1 pairs</source>
        <translation>इसमें %1 से अधिक जोड़े हैं</translation>
    </message>
    <message>
        <source>a pair names a scan beyond those there can be</source>
        <translation>एक जोड़ा संभव स्कैनों से परे का स्कैन बताता है</translation>
    </message>
    <message>
        <source>it has more poses than there can be scans</source>
        <translation>इसमें संभव स्कैनों से अधिक स्थितियाँ हैं</translation>
    </message>
    <message>
        <source>a pose is no rotation and translation</source>
        <translation>एक स्थिति घुमाव और खिसकाव नहीं है</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2; it takes %3 to %4</source>
        <translation>&apos;%1&apos; %2 है; %3 से %4 तक हो सकता है</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not finite; it takes %2 to %3</source>
        <translation>&apos;%1&apos; परिमित नहीं है; %2 से %3 तक हो सकता है</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be above 0 mm</source>
        <translation>&apos;%1&apos; 0 mm से अधिक होना चाहिए</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no rotation: 9 numbers, rows of length 1 at right angles, right-handed</source>
        <translation>&apos;%1&apos; घुमाव नहीं है: 9 संख्याएँ, लंबाई 1 की समकोण पंक्तियाँ, दक्षिणावर्ती</translation>
    </message>
    <message>
        <source>The scans are not all in one unit: %1 is in %2, %3 in %4. Nothing was done. Give --unit if it is the same for all.</source>
        <translation>स्कैन सब एक इकाई में नहीं हैं: %1 की इकाई %2 है, %3 की %4। कुछ नहीं किया गया। सबकी एक ही हो तो --unit दें।</translation>
    </message>
    <message>
        <source>none that it states</source>
        <translation>कोई बताई हुई नहीं</translation>
    </message>
    <message>
        <source>The files hold more than %1 scans together. Nothing was done. Prepare fewer at once.</source>
        <translation>फ़ाइलों में कुल %1 से अधिक स्कैन हैं। कुछ नहीं किया गया। एक साथ कम तैयार करें।</translation>
    </message>
    <message>
        <source>No point is left after all steps. Nothing was written. Take a step out, or widen its limits.</source>
        <translation>सभी चरणों के बाद कोई बिंदु नहीं बचा। कुछ नहीं लिखा गया। कोई चरण हटाएँ या उसकी सीमाएँ बढ़ाएँ।</translation>
    </message>
    <message>
        <source>The scan is more than 2 097 152 times as long as the distance it should be thinned to. Nothing was thinned; choose a larger distance, or crop the scan first.</source>
        <translation>स्कैन उस दूरी से 2 097 152 गुना से भी लंबा है जिस तक उसे विरल करना था। कुछ विरल नहीं हुआ; बड़ी दूरी चुनें, या पहले स्कैन काटें।</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: the steps take more than %1 s of processor time. Nothing was changed. Thin the scans out first.</source>
        <translation>स्कैन तैयार नहीं हो सकते: चरणों को %1 s से अधिक प्रोसेसर समय चाहिए। कुछ नहीं बदला। पहले स्कैनों को विरल करें।</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: the system stopped the work, probably for lack of memory. Nothing was changed. Close other programs, or thin the scans out first.</source>
        <translation>स्कैन तैयार नहीं हो सकते: सिस्टम ने काम रोक दिया, शायद स्मृति की कमी से। कुछ नहीं बदला। दूसरे प्रोग्राम बंद करें, या पहले स्कैनों को विरल करें।</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: the program that does it broke down. Nothing was changed. Leave out one step after the other to find the one.</source>
        <translation>स्कैन तैयार नहीं हो सकते: यह काम करने वाला प्रोग्राम टूट गया। कुछ नहीं बदला। दोषी चरण खोजने के लिए एक-एक करके चरण छोड़ें।</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: the program that does it broke down (&quot;%1&quot;). Nothing was changed. Leave out one step after the other to find the one.</source>
        <translation>स्कैन तैयार नहीं हो सकते: यह काम करने वाला प्रोग्राम टूट गया (&quot;%1&quot;)। कुछ नहीं बदला। दोषी चरण खोजने के लिए एक-एक करके चरण छोड़ें।</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: the system gives no memory for them. Nothing was changed. Close other programs and try again.</source>
        <translation>स्कैन तैयार नहीं हो सकते: सिस्टम उनके लिए स्मृति नहीं देता। कुछ नहीं बदला। दूसरे प्रोग्राम बंद करें और फिर कोशिश करें।</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: a step needs more than %1 MB of memory. Nothing was changed. Crop or thin them first, or allow more (--memory).</source>
        <translation>स्कैन तैयार नहीं हो सकते: एक चरण को %1 MB से अधिक स्मृति चाहिए। कुछ नहीं बदला। पहले उन्हें काटें या विरल करें, या अधिक की अनुमति दें (--memory)।</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: a library gave up (%1). Nothing was changed.</source>
        <translation>स्कैन तैयार नहीं हो सकते: एक लाइब्रेरी ने हार मान ली (%1)। कुछ नहीं बदला।</translation>
    </message>
    <message>
        <source>The scans did not arrive whole. Nothing was changed. Try again.</source>
        <translation>स्कैन पूरे नहीं पहुँचे। कुछ नहीं बदला। फिर कोशिश करें।</translation>
    </message>
    <message>
        <source>The scan cannot be passed on: %1. Nothing was done. Close other programs and try again.</source>
        <translation>स्कैन आगे नहीं दिया जा सकता: %1। कुछ नहीं किया गया। दूसरे प्रोग्राम बंद करें और फिर कोशिश करें।</translation>
    </message>
    <message>
        <source>Aligning needs two scans or more, one of them the reference. Nothing was aligned.</source>
        <translation>संरेखण को दो या अधिक स्कैन चाहिए, उनमें एक संदर्भ। कुछ संरेखित नहीं हुआ।</translation>
    </message>
    <message>
        <source>A picked pair names scan %1; there are %2, counted from 1. Nothing was aligned.</source>
        <translation>एक चुना हुआ जोड़ा स्कैन %1 बताता है; %2 हैं, 1 से गिने हुए। कुछ संरेखित नहीं हुआ।</translation>
    </message>
    <message>
        <source>A picked pair names scan %1, which is the reference; there are %2, counted from 1. Nothing was aligned.</source>
        <translation>एक चुना हुआ जोड़ा स्कैन %1 बताता है, जो संदर्भ है; %2 हैं, 1 से गिने हुए। कुछ संरेखित नहीं हुआ।</translation>
    </message>
    <message>
        <source>%1 has another unit than %2. Nothing was aligned; only scans of one unit can be.</source>
        <translation>%1 की इकाई %2 से अलग है। कुछ संरेखित नहीं हुआ; केवल एक इकाई के स्कैन हो सकते हैं।</translation>
    </message>
    <message>
        <source>%1: {2|%2 different point|%2 different points}; aligning needs %3 in every scan. Nothing was aligned; leave this scan out.</source>
        <translation>%1: %2 अलग बिंदु; संरेखण को हर स्कैन में %3 चाहिए। कुछ संरेखित नहीं हुआ; यह स्कैन छोड़ दें।</translation>
    </message>
    <message>
        <source>%1: its points stand too far apart to be a surface. Nothing was aligned; leave this scan out.</source>
        <translation>%1: इसके बिंदु सतह होने के लिए बहुत दूर-दूर हैं। कुछ संरेखित नहीं हुआ; यह स्कैन छोड़ दें।</translation>
    </message>
    <message>
        <source>%1: {2|%2 picked pair|%2 picked pairs}; three or more are needed. Nothing was aligned.</source>
        <translation>%1: {2|%2 चुना हुआ जोड़ा|%2 चुने हुए जोड़े}; तीन या अधिक चाहिए। कुछ संरेखित नहीं हुआ।</translation>
    </message>
    <message>
        <source>%1: the picked places lie nearly in one line, which leaves open how the scan is turned about it. Nothing was aligned; pick one more place well beside that line.</source>
        <translation>%1: चुनी हुई जगहें लगभग एक रेखा में हैं, इसलिए स्कैन उसके चारों ओर कैसे घूमा है यह खुला रहता है। कुछ संरेखित नहीं हुआ; उस रेखा से काफ़ी हटकर एक और जगह चुनें।</translation>
    </message>
    <message>
        <source>%1: the picked places are not equally far from each other on the two scans. Nothing was aligned; look whether the pairs are in the same order and the scans in the same unit.</source>
        <translation>%1: चुनी हुई जगहें दोनों स्कैन पर एक-दूसरे से समान दूरी पर नहीं हैं। कुछ संरेखित नहीं हुआ; देखें कि जोड़े एक ही क्रम में और स्कैन एक ही इकाई में हैं या नहीं।</translation>
    </message>
    <message>
        <source>%1 states no classes; all its points stay.</source>
        <translation>%1 में वर्ग नहीं दिए गए; इसके सभी बिंदु रहते हैं।</translation>
    </message>
    <message>
        <source>%1 states no pulses with several returns; all its points stay.</source>
        <translation>%1 में कई वापसियों वाले स्पंद नहीं दिए गए; इसके सभी बिंदु रहते हैं।</translation>
    </message>
    <message>
        <source>%1 states no intensities; all its points stay.</source>
        <translation>%1 में तीव्रता नहीं दी गई; इसके सभी बिंदु रहते हैं।</translation>
    </message>
    <message>
        <source>the joined scans</source>
        <translation>जोड़े गए स्कैनों</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>less than 0.1 %</source>
        <translation>0.1 % से कम</translation>
    </message>
    <message>
        <source>All points of %1 are one place, which has no spacing.</source>
        <translation>%1 के सभी बिंदु एक ही जगह हैं, जिसकी कोई दूरी नहीं होती।</translation>
    </message>
    <message>
        <source>{1|%1 point has|%1 points have} no normal: too few neighbours.</source>
        <translation>{1|%1 बिंदु का|%1 बिंदुओं का} अभिलंब नहीं है: पड़ोसी बहुत कम हैं।</translation>
    </message>
    <message>
        <source>%1 of the points of %2 were left out; those are more than strays. Look at the result.</source>
        <translation>%2 के %1 बिंदु छोड़े गए; ये भटके बिंदुओं से अधिक हैं। परिणाम देखें।</translation>
    </message>
    <message>
        <source>No three points of %1 span a plane; they stay as they are.</source>
        <translation>%1 के कोई तीन बिंदु तल नहीं बनाते; वे जैसे हैं वैसे रहते हैं।</translation>
    </message>
    <message>
        <source>One plane holds %1 of the points of %2.</source>
        <translation>एक तल पर %2 के %1 बिंदु हैं।</translation>
    </message>
    <message>
        <source>One plane holds %1 of the points of %2; that is hardly a base. Look at the result.</source>
        <translation>एक तल पर %2 के %1 बिंदु हैं; यह शायद ही आधार है। परिणाम देखें।</translation>
    </message>
    <message>
        <source>This program aligns no scans. They stay where their files have them; give their poses in a recipe, or leave the step out.</source>
        <translation>यह प्रोग्राम स्कैन संरेखित नहीं करता। वे वहीं रहते हैं जहाँ उनकी फ़ाइलें उन्हें रखती हैं; उनकी स्थितियाँ विधि में दें, या यह चरण छोड़ दें।</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <translation>%1 छोड़ा गया: %2</translation>
    </message>
    <message>
        <source>The reference.</source>
        <translation>संदर्भ।</translation>
    </message>
    <message>
        <source>As stored.</source>
        <translation>जैसा सहेजा गया।</translation>
    </message>
    <message>
        <source>The pose that was found before was used.</source>
        <translation>पहले मिली स्थिति काम में ली गई।</translation>
    </message>
    <message>
        <source>%1 rms over %2 in common.</source>
        <translation>%2 साझा सतह पर %1 rms।</translation>
    </message>
    <message>
        <source>%1 rms over %2 in common. Weak %3: about %4.</source>
        <translation>%2 साझा सतह पर %1 rms। कमज़ोर पकड़ %3: लगभग %4।</translation>
    </message>
    <message>
        <source>%1 rms over %2 in common. Nothing in the shape holds it %3: there it lies as it was placed by hand.</source>
        <translation>%2 साझा सतह पर %1 rms। आकृति में कुछ भी इसे %3 नहीं रोकता: वहाँ यह वैसे ही है जैसे हाथ से रखा गया।</translation>
    </message>
    <message>
        <source>Not aligned: %1.</source>
        <translation>संरेखित नहीं हुआ: %1।</translation>
    </message>
    <message>
        <source>hardly anything of it lies on the others</source>
        <translation>इसका शायद ही कुछ दूसरों पर है</translation>
    </message>
    <message>
        <source>only %1 of it lies on the others</source>
        <translation>इसका केवल %1 दूसरों पर है</translation>
    </message>
    <message>
        <source>it touches the others, but does not lie on them</source>
        <translation>यह दूसरों को छूता है, पर उन पर नहीं है</translation>
    </message>
    <message>
        <source>nothing in its shape says where it belongs %1</source>
        <translation>इसकी आकृति में कुछ नहीं बताता कि %1 यह कहाँ है</translation>
    </message>
    <message>
        <source>no place was found where it fits</source>
        <translation>कोई जगह नहीं मिली जहाँ यह बैठे</translation>
    </message>
    <message>
        <source>it meets none of the others</source>
        <translation>यह दूसरों में से किसी से नहीं मिलता</translation>
    </message>
    <message>
        <source>By itself it lies elsewhere on %1 than by way of the others; look at this pair.</source>
        <translation>अकेले में यह %1 पर दूसरों के रास्ते से अलग जगह है; इस जोड़े को देखें।</translation>
    </message>
    <message>
        <source>turning about %1</source>
        <translation>%1 के चारों ओर घूमने में</translation>
    </message>
    <message>
        <source>along %1</source>
        <translation>%1 की दिशा में</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>The map&apos;s holes are too many to count. Nothing was made.</source>
        <translation>मानचित्र में इतने छेद हैं कि गिने नहीं जा सकते। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>The map&apos;s empty areas are so ragged that they alone take more than the memory allowed. Nothing was made. Allow more memory, or choose larger cells.</source>
        <translation>मानचित्र के खाली क्षेत्र इतने कटे-फटे हैं कि वे अकेले ही अनुमत स्मृति से अधिक लेते हैं। कुछ नहीं बना। अधिक स्मृति की अनुमति दें, या बड़े खाने चुनें।</translation>
    </message>
    <message>
        <source>Points and heights that do not fit into memory cannot be kept in %1: %2. Nothing was made. Free some space there, write the result to another disk, or allow more memory.</source>
        <translation>जो बिंदु और ऊँचाइयाँ स्मृति में नहीं आतीं, वे %1 में नहीं रखी जा सकतीं: %2। कुछ नहीं बना। वहाँ जगह खाली करें, परिणाम दूसरी डिस्क पर लिखें, या अधिक स्मृति की अनुमति दें।</translation>
    </message>
    <message>
        <source>The region names a level that the map does not have.</source>
        <translation>क्षेत्र ऐसा स्तर बताता है जो मानचित्र में नहीं है।</translation>
    </message>
    <message>
        <source>Cannot read %1 as a tiled map: %2. Make the levels again with relievo pyramid --memory.</source>
        <translation>%1 टाइलों वाले मानचित्र के रूप में नहीं पढ़ा जा सकता: %2। स्तर relievo pyramid --memory से फिर बनाएँ।</translation>
    </message>
    <message>
        <source>it has another number of bands</source>
        <translation>इसमें बैंडों की संख्या दूसरी है</translation>
    </message>
    <message>
        <source>it is compressed</source>
        <translation>यह संपीड़ित है</translation>
    </message>
    <message>
        <source>its bands are mixed</source>
        <translation>इसके बैंड मिले हुए हैं</translation>
    </message>
    <message>
        <source>its tiles have another size</source>
        <translation>इसकी टाइलों का आकार दूसरा है</translation>
    </message>
    <message>
        <source>its cells are of another type</source>
        <translation>इसके खाने दूसरे प्रकार के हैं</translation>
    </message>
    <message>
        <source>its bytes are in another order</source>
        <translation>इसके बाइट दूसरे क्रम में हैं</translation>
    </message>
    <message>
        <source>it is no readable GeoTIFF</source>
        <translation>यह पढ़ा जा सकने वाला GeoTIFF नहीं है</translation>
    </message>
    <message>
        <source>a tile is missing</source>
        <translation>एक टाइल नहीं है</translation>
    </message>
    <message>
        <source>it became shorter while it was read, or its disk failed</source>
        <translation>यह पढ़ते समय छोटी हो गई, या इसकी डिस्क विफल हुई</translation>
    </message>
    <message>
        <source>its entry %1 is missing or makes no sense</source>
        <translation>इसकी प्रविष्टि %1 नहीं है या निरर्थक है</translation>
    </message>
    <message>
        <source>a height is not finite</source>
        <translation>एक ऊँचाई परिमित नहीं है</translation>
    </message>
    <message>
        <source>a code is none of an origin</source>
        <translation>एक कोड किसी उद्गम का नहीं है</translation>
    </message>
    <message>
        <source>its number of levels or its factor makes no sense</source>
        <translation>इसके स्तरों की संख्या या गुणक निरर्थक है</translation>
    </message>
    <message>
        <source>its spacing is not above 0</source>
        <translation>इसकी दूरी 0 से अधिक नहीं है</translation>
    </message>
    <message>
        <source>it belongs to another map</source>
        <translation>यह दूसरे मानचित्र की है</translation>
    </message>
    <message>
        <source>its size is not that of the level</source>
        <translation>इसका आकार स्तर का नहीं है</translation>
    </message>
    <message>
        <source>its lowest height is above its highest</source>
        <translation>इसकी सबसे कम ऊँचाई सबसे अधिक से ऊपर है</translation>
    </message>
    <message>
        <source>its number of cells of one origin makes no sense</source>
        <translation>एक उद्गम के खानों की संख्या निरर्थक है</translation>
    </message>
    <message>
        <source>its cells by origin are not all its cells</source>
        <translation>उद्गम के अनुसार इसके खाने सारे खाने नहीं हैं</translation>
    </message>
    <message>
        <source>it is a level of another map</source>
        <translation>यह दूसरे मानचित्र का एक स्तर है</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no recording of &apos;%2&apos; but of another file (checksum differs, E501). Nothing was drawn. Choose a recording of this one.</source>
        <translation>&apos;%1&apos; &apos;%2&apos; की नहीं, किसी दूसरी फ़ाइल की रिकॉर्डिंग है (जाँच-योग अलग है, E501)। कुछ नहीं बनाया गया। इसी की रिकॉर्डिंग चुनें।</translation>
    </message>
    <message>
        <source>A figure&apos;s name ends in .png, .tif, .pdf or .svg; &apos;%1&apos; does not. Nothing was drawn.</source>
        <translation>चित्र का नाम .png, .tif, .pdf या .svg पर समाप्त होता है; &apos;%1&apos; नहीं। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>The name of a figure&apos;s heights ends in .tif; &apos;%1&apos; does not. Nothing was drawn.</source>
        <translation>चित्र की ऊँचाइयों का नाम .tif पर समाप्त होता है; &apos;%1&apos; नहीं। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>Two of the figure&apos;s files would be &apos;%1&apos;. Nothing was drawn. Give one of them another name.</source>
        <translation>चित्र की दो फ़ाइलों का नाम &apos;%1&apos; होगा। कुछ नहीं बनाया गया। उनमें से एक को दूसरा नाम दें।</translation>
    </message>
    <message>
        <source>This figure would be %1 x %2 mm large. Nothing was drawn. Choose a smaller scale or width.</source>
        <translation>यह चित्र %1 x %2 mm बड़ा होगा। कुछ नहीं बनाया गया। छोटा पैमाना या कम चौड़ाई चुनें।</translation>
    </message>
    <message>
        <source>This figure would be %1 x %2 mm small, and at least 20 mm wide it must be. Nothing was drawn. Choose a larger scale, 1:N with a smaller N.</source>
        <translation>यह चित्र केवल %1 x %2 mm का होगा, पर कम से कम 20 mm चौड़ा होना चाहिए। कुछ नहीं बनाया गया। बड़ा पैमाना चुनें, छोटे N वाला 1:N।</translation>
    </message>
    <message>
        <source>Numbers of %1 points leave no room for plots on %2 mm. Nothing was drawn. Choose a smaller text or a larger width.</source>
        <translation>%1 पॉइंट की संख्याएँ %2 mm पर आरेख के लिए जगह नहीं छोड़तीं। कुछ नहीं बनाया गया। छोटा पाठ या अधिक चौड़ाई चुनें।</translation>
    </message>
    <message>
        <source>There is nothing of the object in this region. Choose another.</source>
        <translation>इस विंडो में वस्तु का कुछ नहीं है। दूसरी चुनें।</translation>
    </message>
    <message>
        <source>Level %1 has more than %2 samples across this region. Choose a coarser level.</source>
        <translation>स्तर %1 में इस विंडो के आर-पार %2 से अधिक नमूने हैं। मोटा स्तर चुनें।</translation>
    </message>
    <message>
        <source>There is no surface along this line.</source>
        <translation>इस रेखा के साथ कोई सतह नहीं है।</translation>
    </message>
    <message>
        <source>This is a picture of the %1, which only the window can draw. Nothing was drawn. Open it with relievo to get its state back.</source>
        <translation>यह %1 की तस्वीर है, जिसे केवल खिड़की बना सकती है। कुछ नहीं बनाया गया। उसकी स्थिति वापस पाने के लिए उसे relievo से खोलें।</translation>
    </message>
    <message>
        <source>Cannot write the picture &apos;%1&apos; (%2). Choose another folder or free some space.</source>
        <translation>तस्वीर &apos;%1&apos; लिखी नहीं जा सकती (%2)। दूसरा फ़ोल्डर चुनें या जगह खाली करें।</translation>
    </message>
    <message>
        <source>Cannot write the picture &apos;%1&apos;. Choose another folder or free some space.</source>
        <translation>तस्वीर &apos;%1&apos; लिखी नहीं जा सकती। दूसरा फ़ोल्डर चुनें या जगह खाली करें।</translation>
    </message>
    <message>
        <source>The graphics driver returned a black picture. Try a smaller one.</source>
        <translation>ग्राफ़िक्स ड्राइवर ने काली तस्वीर दी। छोटी आज़माएँ।</translation>
    </message>
    <message>
        <source>The graphics driver cannot draw pictures of %1 x %2 pixels. Choose a smaller size.</source>
        <translation>ग्राफ़िक्स ड्राइवर %1 x %2 पिक्सेल की तस्वीरें नहीं बना सकता। छोटा आकार चुनें।</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is more than this version can hold, %3 million in all. Nothing was drawn. Choose a smaller one.</source>
        <translation>%1 x %2 पिक्सेल का चित्र इस संस्करण की क्षमता (कुल %3 मिलियन) से अधिक है। कुछ नहीं बनाया गया। छोटा चित्र चुनें।</translation>
    </message>
    <message>
        <source>There is not enough memory to draw: the graphics driver needs 512 MB of address space, and a limit that was set (ulimit -v) leaves less. Nothing was drawn. Raise the limit.</source>
        <translation>चित्र बनाने के लिए मेमोरी पर्याप्त नहीं है: ग्राफ़िक्स ड्राइवर को 512 MB पता-स्थान चाहिए, और लगाई गई सीमा (ulimit -v) कम छोड़ती है। कुछ नहीं बनाया गया। सीमा बढ़ाएँ।</translation>
    </message>
    <message>
        <source>There is no display to draw with. Set DISPLAY, or start the program on a desktop or under xvfb-run.</source>
        <translation>चित्र बनाने के लिए कोई डिस्प्ले नहीं है। DISPLAY सेट करें, या प्रोग्राम को डेस्कटॉप पर या xvfb-run से चलाएँ।</translation>
    </message>
    <message>
        <source>Cannot make a pipe to start Xvfb. Close other programs and try again.</source>
        <translation>Xvfb शुरू करने के लिए पाइप नहीं बन सकता। दूसरे प्रोग्राम बंद करें और फिर कोशिश करें।</translation>
    </message>
    <message>
        <source>There is no display, and Xvfb did not start. Install the package xvfb, or run this on a desktop.</source>
        <translation>कोई डिस्प्ले नहीं है, और Xvfb शुरू नहीं हुआ। पैकेज xvfb लगाएँ, या इसे डेस्कटॉप पर चलाएँ।</translation>
    </message>
    <message>
        <source>A picture needs a width and a height above 0.</source>
        <translation>चित्र को 0 से अधिक चौड़ाई और ऊँचाई चाहिए।</translation>
    </message>
    <message>
        <source>The graphics driver returned a black picture of %1 x %2 pixels. Try a smaller one.</source>
        <translation>ग्राफ़िक्स ड्राइवर ने %1 x %2 पिक्सेल का काला चित्र लौटाया। छोटा आज़माएँ।</translation>
    </message>
    <message>
        <source>A PNG text entry&apos;s name has 1 to 79 characters, not &apos;%1&apos;.</source>
        <translation>PNG की पाठ-प्रविष्टि के नाम में 1 से 79 अक्षर होते हैं, &apos;%1&apos; नहीं।</translation>
    </message>
    <message>
        <source>There is no picture to write to &apos;%1&apos;.</source>
        <translation>&apos;%1&apos; में लिखने के लिए कोई चित्र नहीं है।</translation>
    </message>
    <message>
        <source>A surface to draw needs one height and at most one origin and colour per sample.</source>
        <translation>बनाने की सतह को हर नमूने पर एक ऊँचाई और अधिक से अधिक एक उद्गम और रंग चाहिए।</translation>
    </message>
    <message>
        <source>A surface to draw needs at least 2 x 2 samples and a spacing above 0.</source>
        <translation>बनाने की सतह को कम से कम 2 x 2 नमूने और 0 से अधिक दूरी चाहिए।</translation>
    </message>
    <message>
        <source>A depth map needs at least one sample and a spacing above 0.</source>
        <translation>गहराई मानचित्र को कम से कम एक नमूना और 0 से अधिक दूरी चाहिए।</translation>
    </message>
    <message>
        <source>A camera needs a rectangle with a width and a height above 0.</source>
        <translation>कैमरे को 0 से अधिक चौड़ाई और ऊँचाई का आयत चाहिए।</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made. Nothing was written. Choose another place.</source>
        <translation>फ़ोल्डर &quot;%1&quot; बनाया नहीं जा सकता। कुछ नहीं लिखा गया। दूसरी जगह चुनें।</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds frames of a video already. Nothing was written. Choose another.</source>
        <translation>फ़ोल्डर &quot;%1&quot; में पहले से किसी वीडियो के फ़्रेम हैं। कुछ नहीं लिखा गया। दूसरा चुनें।</translation>
    </message>
    <message>
        <source>Video stopped: disk full. %1 s ({2|%2 frame|%2 frames}) are saved and complete in &quot;%3&quot;.</source>
        <translation>वीडियो रुका: डिस्क भर गई। %1 s (%2 फ़्रेम) &quot;%3&quot; में सहेजे गए और पूरे हैं।</translation>
    </message>
    <message>
        <source>The program ffmpeg is not installed, which packs videos. Nothing was written. Install the package ffmpeg, or choose the profile images: a folder of pictures.</source>
        <translation>वीडियो पैक करने वाला प्रोग्राम ffmpeg लगा नहीं है। कुछ नहीं लिखा गया। पैकेज ffmpeg लगाएँ, या प्रोफ़ाइल images चुनें: चित्रों का फ़ोल्डर।</translation>
    </message>
    <message>
        <source>The video &quot;%1&quot; cannot be written: %2. Choose another place.</source>
        <translation>वीडियो &quot;%1&quot; लिखा नहीं जा सकता: %2। दूसरी जगह चुनें।</translation>
    </message>
    <message>
        <source>The encoder cannot be reached: %1.</source>
        <translation>एनकोडर तक पहुँचा नहीं जा सकता: %1।</translation>
    </message>
    <message>
        <source>ffmpeg could not pack the video. Nothing was kept. Choose another size or profile.</source>
        <translation>ffmpeg वीडियो पैक नहीं कर सका। कुछ नहीं रखा गया। दूसरा आकार या प्रोफ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>ffmpeg could not pack the video (&quot;%1&quot;). Nothing was kept. Choose another size or profile.</source>
        <translation>ffmpeg वीडियो पैक नहीं कर सका (&quot;%1&quot;)। कुछ नहीं रखा गया। दूसरा आकार या प्रोफ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>A video&apos;s name must end in .mp4. Nothing was made.</source>
        <translation>वीडियो का नाम .mp4 पर समाप्त होना चाहिए। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>Video stopped: %1. %2 s ({3|%3 frame|%3 frames}) are saved and complete in &quot;%4&quot;.</source>
        <translation>वीडियो रुका: %1। %2 s (%3 फ़्रेम) &quot;%4&quot; में सहेजे गए और पूरे हैं।</translation>
    </message>
    <message>
        <source>Video stopped: %1. Nothing of it could be kept.</source>
        <translation>वीडियो रुका: %1। उसका कुछ भी नहीं रखा जा सका।</translation>
    </message>
    <message>
        <source>disk full</source>
        <translation>डिस्क भर गई</translation>
    </message>
    <message>
        <source>Video stopped: %1 {2|%2 frame is|%2 frames are} saved and complete in &quot;%3&quot;.</source>
        <translation>वीडियो रुका: %1 {2|%2 फ़्रेम|%2 फ़्रेम} &quot;%3&quot; में सहेजे गए और पूरे हैं।</translation>
    </message>
    <message>
        <source>%1 is a recording of %2, another file. Nothing was packed. Leave it out.</source>
        <translation>%1 %2 की रिकॉर्डिंग है, जो दूसरी फ़ाइल है। कुछ पैक नहीं हुआ। इसे छोड़ दें।</translation>
    </message>
    <message>
        <source>No map is open that the raster could lie on.</source>
        <translation>कोई मानचित्र खुला नहीं है जिस पर रास्टर रखा जा सके।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changed since it was read. Nothing was written. Close the dialog and open the file again.</source>
        <translation>&apos;%1&apos; पढ़े जाने के बाद बदल गई है। कुछ नहीं लिखा गया। संवाद बंद करें और फ़ाइल फिर खोलें।</translation>
    </message>
    <message>
        <source>%1 is still being read. Nothing was saved. Save again when the list shows its value.</source>
        <translation>%1 अभी पढ़ा जा रहा है। कुछ सहेजा नहीं गया। सूची में इसका मान दिखने पर फिर सहेजें।</translation>
    </message>
    <message>
        <source>Select a profile or a section in the list first.</source>
        <translation>पहले सूची में एक प्रोफ़ाइल या काट चुनें।</translation>
    </message>
    <message>
        <source>Pictures cannot be drawn: the program relievo-draw, which does it, is not installed. Nothing was done. Install relievo with its drawing part.</source>
        <translation>चित्र नहीं बनाए जा सकते: उन्हें बनाने वाला प्रोग्राम relievo-draw इंस्टॉल नहीं है। कुछ नहीं किया गया। relievo को चित्र बनाने वाले भाग के साथ इंस्टॉल करें।</translation>
    </message>
    <message>
        <source>The window is not installed. Install the package relievo, or use a verb, which needs no window: &apos;relievo --help&apos; lists the verbs.</source>
        <translation>विंडो इंस्टॉल नहीं है। relievo पैकेज इंस्टॉल करें, या ऐसा आदेश चुनें जिसे विंडो नहीं चाहिए: &quot;relievo --help&quot; आदेशों की सूची देता है।</translation>
    </message>
    <message>
        <source>The program %1 cannot be started: %2. Nothing was done. Install relievo again.</source>
        <translation>प्रोग्राम %1 शुरू नहीं हो सकता: %2। कुछ नहीं किया गया। relievo फिर से इंस्टॉल करें।</translation>
    </message>
    <message>
        <source>The part %1 of relievo cannot be loaded: %2. Nothing was written. Install relievo again.</source>
        <translation>relievo का भाग %1 लोड नहीं हो सकता: %2। कुछ नहीं लिखा गया। relievo फिर से इंस्टॉल करें।</translation>
    </message>
    <message>
        <source>Windows are suggested for maps that fit into memory; this one is read by tiles. Nothing was made. Give a level of it, or a map with larger cells.</source>
        <translation>खिड़कियाँ उन नक्शों के लिए सुझाई जाती हैं जो मेमोरी में समाते हैं; यह टाइलों से पढ़ा जाता है। कुछ नहीं बनाया गया। उसका कोई स्तर दें, या बड़ी कोशिकाओं वाला नक्शा।</translation>
    </message>
    <message>
        <source>%1 is no plugin of relievo. It was not loaded. Take it out of the folder of plugins.</source>
        <translation>%1 relievo का प्लगइन नहीं है। इसे लोड नहीं किया गया। इसे प्लगइनों के फ़ोल्डर से हटा दें।</translation>
    </message>
    <message>
        <source>%1 was built for version %2 of the plugin interface, and this relievo has version %3. It was not loaded. Build it again with the headers of this relievo.</source>
        <translation>%1 प्लगइन इंटरफ़ेस के संस्करण %2 के लिए बनाया गया था, और इस relievo का संस्करण %3 है। इसे लोड नहीं किया गया। इसे इस relievo की हेडर फ़ाइलों से फिर बनाएँ।</translation>
    </message>
    <message>
        <source>%1 cannot be loaded: %2. Build or install it again.</source>
        <translation>%1 लोड नहीं हो सकता: %2। इसे फिर बनाएँ या फिर इंस्टॉल करें।</translation>
    </message>
    <message>
        <source>The plugin %1 could not start and was left out: %2. All else works.</source>
        <translation>प्लगइन %1 शुरू नहीं हो सका और छोड़ दिया गया: %2। बाकी सब काम करता है।</translation>
    </message>
    <message>
        <source>The plugin %1 could not take its settings back and was left out: %2. Its settings were kept; all else works.</source>
        <translation>प्लगइन %1 अपनी सेटिंग वापस नहीं ले सका और छोड़ दिया गया: %2। उसकी सेटिंग रखी गई हैं; बाकी सब काम करता है।</translation>
    </message>
    <message>
        <source>The plugin %1 could not tell its settings: %2. Those it had before were kept.</source>
        <translation>प्लगइन %1 अपनी सेटिंग नहीं बता सका: %2। पहले की सेटिंग रखी गई हैं।</translation>
    </message>
    <message>
        <source>it threw something that says no reason</source>
        <translation>उसने ऐसा कुछ फेंका जो कारण नहीं बताता</translation>
    </message>
    <message>
        <source>SpaceMouse, foot switches and gamepads cannot be used: %1. Install the library, or go on without them.</source>
        <translation>SpaceMouse, पैर के स्विच और गेमपैड काम में नहीं लिए जा सकते: %1। लाइब्रेरी इंस्टॉल करें, या उनके बिना आगे बढ़ें।</translation>
    </message>
    <message>
        <source>A touch along this stroke has %1 rows, which need about %2 MB; %3 MB are free. Nothing was made. Are its times in seconds? Give a shorter stroke.</source>
        <translation>इस रेखा के साथ स्पर्श में %1 पंक्तियाँ हैं, जिन्हें लगभग %2 MB चाहिए; %3 MB खाली हैं। कुछ नहीं बनाया गया। क्या इसके समय सेकंड में हैं? छोटी रेखा दें।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no device of a plug-in. Write plugin:FILE/ID as &apos;relievo devices&apos; lists them.</source>
        <translation>&quot;%1&quot; किसी प्लगइन के उपकरण का नाम नहीं है। plugin:FILE/ID वैसे लिखें जैसे &apos;relievo devices&apos; दिखाता है।</translation>
    </message>
    <message>
        <source>There is no plug-in &quot;%1&quot; for devices. &apos;relievo devices&apos; lists those that were found.</source>
        <translation>उपकरणों के लिए कोई प्लगइन &quot;%1&quot; नहीं है। &apos;relievo devices&apos; मिले हुए प्लगइन दिखाता है।</translation>
    </message>
    <message>
        <source>The plug-in %1 was not allowed yet, or was changed since. If you know where it is from, allow it by &apos;relievo devices --trust %1&apos;, then try again.</source>
        <translation>प्लगइन %1 को अभी अनुमति नहीं मिली है, या वह उसके बाद बदला गया है। यदि आप जानते हैं कि वह कहाँ से है, तो &apos;relievo devices --trust %1&apos; से अनुमति दें, फिर दोबारा प्रयास करें।</translation>
    </message>
    <message>
        <source>The plug-in %1 cannot be read: %2.</source>
        <translation>प्लगइन %1 पढ़ा नहीं जा सकता: %2।</translation>
    </message>
    <message>
        <source>The device %1 was not opened: %2.</source>
        <translation>उपकरण %1 नहीं खोला गया: %2।</translation>
    </message>
    <message>
        <source>The program that runs a device&apos;s plug-in could not be started: %1.</source>
        <translation>उपकरण का प्लगइन चलाने वाला प्रोग्राम शुरू नहीं हो सका: %1।</translation>
    </message>
    <message>
        <source>its plug-in crashed (signal %1)</source>
        <translation>उसका प्लगइन विफल होकर बंद हो गया (संकेत %1)</translation>
    </message>
    <message>
        <source>its plug-in ended the process that it runs in</source>
        <translation>उसके प्लगइन ने वह प्रक्रिया समाप्त कर दी जिसमें वह चलता है</translation>
    </message>
    <message>
        <source>it was not ready within {1|%1 second|%1 seconds}</source>
        <translation>वह %1 सेकंड में तैयार नहीं हुआ</translation>
    </message>
    <message>
        <source>its plug-in cannot be loaded (%1)</source>
        <translation>उसका प्लगइन लोड नहीं हो सकता (%1)</translation>
    </message>
    <message>
        <source>the file is no plug-in for devices: it exports no relievo_device_entry</source>
        <translation>यह फ़ाइल उपकरणों का प्लगइन नहीं है: वह relievo_device_entry निर्यात नहीं करती</translation>
    </message>
    <message>
        <source>its plug-in is made for version %1 of the interface for devices, and this program has version %2</source>
        <translation>उसका प्लगइन उपकरण-इंटरफ़ेस के संस्करण %1 के लिए बना है, और इस प्रोग्राम में संस्करण %2 है</translation>
    </message>
    <message>
        <source>its plug-in lacks a function or a name that every plug-in must have</source>
        <translation>उसके प्लगइन में वह फ़ंक्शन या नाम नहीं है जो हर प्लगइन में होना चाहिए</translation>
    </message>
    <message>
        <source>its plug-in could not begin (status %1)</source>
        <translation>उसका प्लगइन आरंभ नहीं हो सका (स्थिति %1)</translation>
    </message>
    <message>
        <source>its plug-in knows no device of this name</source>
        <translation>उसका प्लगइन इस नाम का कोई उपकरण नहीं जानता</translation>
    </message>
    <message>
        <source>its plug-in says: %1</source>
        <translation>उसका प्लगइन कहता है: %1</translation>
    </message>
    <message>
        <source>the limits that its plug-in tells are impossible</source>
        <translation>उसका प्लगइन जो सीमाएँ बताता है वे असंभव हैं</translation>
    </message>
    <message>
        <source>{1|%1 millimetre|%1 millimetres}</source>
        <translation>%1 मिलीमीटर</translation>
    </message>
    <message>
        <source>{1|%1 centimetre|%1 centimetres}</source>
        <translation>%1 सेंटीमीटर</translation>
    </message>
    <message>
        <source>{1|%1 metre|%1 metres}</source>
        <translation>%1 मीटर</translation>
    </message>
    <message>
        <source>%1 millimetres</source>
        <translation>%1 मिलीमीटर</translation>
    </message>
    <message>
        <source>%1 centimetres</source>
        <translation>%1 सेंटीमीटर</translation>
    </message>
    <message>
        <source>%1 metres</source>
        <translation>%1 मीटर</translation>
    </message>
    <message>
        <source>nearly %1</source>
        <translation>लगभग %1</translation>
    </message>
    <message>
        <source>a little over %1</source>
        <translation>%1 से थोड़ा अधिक</translation>
    </message>
    <message>
        <source>about a half</source>
        <translation>लगभग आधा भाग</translation>
    </message>
    <message>
        <source>about a third</source>
        <translation>लगभग एक तिहाई भाग</translation>
    </message>
    <message>
        <source>about a quarter</source>
        <translation>लगभग एक चौथाई भाग</translation>
    </message>
    <message>
        <source>about a fifth</source>
        <translation>लगभग पाँचवाँ भाग</translation>
    </message>
    <message>
        <source>about a sixth</source>
        <translation>लगभग छठा भाग</translation>
    </message>
    <message>
        <source>about an eighth</source>
        <translation>लगभग आठवाँ भाग</translation>
    </message>
    <message>
        <source>about a tenth</source>
        <translation>लगभग दसवाँ भाग</translation>
    </message>
    <message>
        <source>%1 percent</source>
        <translation>%1 प्रतिशत भाग</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>ऊपर बाएँ</translation>
    </message>
    <message>
        <source>top middle</source>
        <translation>ऊपर बीच में</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>ऊपर दाएँ</translation>
    </message>
    <message>
        <source>middle left</source>
        <translation>बीच में बाएँ</translation>
    </message>
    <message>
        <source>in the middle</source>
        <translation>ठीक बीच में</translation>
    </message>
    <message>
        <source>middle right</source>
        <translation>बीच में दाएँ</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>नीचे बाएँ</translation>
    </message>
    <message>
        <source>bottom middle</source>
        <translation>नीचे बीच में</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>नीचे दाएँ</translation>
    </message>
    <message>
        <source>Relief, %1 by %2.</source>
        <translation>उभरी आकृति, %1 गुणा %2।</translation>
    </message>
    <message>
        <source>Relief, %3 by %4.</source>
        <translation>उभरी आकृति, %3 गुणा %4।</translation>
    </message>
    <message>
        <source>Heights from %1 to %2: a span of %3.</source>
        <translation>ऊँचाइयाँ %1 से %2 तक: कुल %3।</translation>
    </message>
    <message>
        <source>Its heights span %4.</source>
        <translation>ऊँचाइयों का फैलाव %4 है।</translation>
    </message>
    <message>
        <source>All heights are the same.</source>
        <translation>सभी ऊँचाइयाँ समान हैं।</translation>
    </message>
    <message>
        <source>There are no heights to describe.</source>
        <translation>वर्णन के लिए कोई ऊँचाई नहीं है।</translation>
    </message>
    <message>
        <source>Highest place: %1, at x %2, y %3, height %4.</source>
        <translation>सबसे ऊँची जगह: %1, x %2, y %3 पर, ऊँचाई %4।</translation>
    </message>
    <message>
        <source>Highest place: %1.</source>
        <translation>सबसे ऊँची जगह: %1।</translation>
    </message>
    <message>
        <source>A raised rim goes all round.</source>
        <translation>चारों ओर उभरा किनारा है।</translation>
    </message>
    <message>
        <source>One raised area: %1, %2 of the surface; %3 wide, %4 high in the picture.</source>
        <translation>एक उभरा क्षेत्र: %1, सतह का %2; चित्र में %3 चौड़ा, %4 ऊँचा।</translation>
    </message>
    <message>
        <source>One raised area: %1, %2 of the surface.</source>
        <translation>एक उभरा क्षेत्र: %1, सतह का %2।</translation>
    </message>
    <message>
        <source>%1 raised areas: %2.</source>
        <translation>%1 उभरे क्षेत्र: %2।</translation>
    </message>
    <message>
        <source>%1 raised areas.</source>
        <translation>%1 उभरे क्षेत्र।</translation>
    </message>
    <message>
        <source>Area %1: %2, %3 of the surface; %4 wide, %5 high in the picture.</source>
        <translation>क्षेत्र %1: %2, सतह का %3; चित्र में %4 चौड़ा, %5 ऊँचा।</translation>
    </message>
    <message>
        <source>Area %1: %2, %3 of the surface.</source>
        <translation>क्षेत्र %1: %2, सतह का %3।</translation>
    </message>
    <message>
        <source>Left and right are nearly mirror images (correlation %1).</source>
        <translation>बायाँ और दायाँ भाग लगभग दर्पण-समान हैं (सहसंबंध %1)।</translation>
    </message>
    <message>
        <source>Left and right are nearly mirror images.</source>
        <translation>बायाँ और दायाँ भाग लगभग दर्पण-समान हैं।</translation>
    </message>
    <message>
        <source>Top and bottom are nearly mirror images (correlation %1).</source>
        <translation>ऊपरी और निचला भाग लगभग दर्पण-समान हैं (सहसंबंध %1)।</translation>
    </message>
    <message>
        <source>Top and bottom are nearly mirror images.</source>
        <translation>ऊपरी और निचला भाग लगभग दर्पण-समान हैं।</translation>
    </message>
    <message>
        <source>Roughest part: %1.</source>
        <translation>सबसे खुरदरा भाग: %1।</translation>
    </message>
    <message>
        <source>Smoothest part: %1.</source>
        <translation>सबसे चिकना भाग: %1।</translation>
    </message>
    <message>
        <source>All of it was measured.</source>
        <translation>पूरी सतह मापी गई है।</translation>
    </message>
    <message>
        <source>Not measured: %1 % of the surface.</source>
        <translation>नहीं मापा गया: सतह का %1 %।</translation>
    </message>
    <message>
        <source>Not measured: %2 of the surface.</source>
        <translation>नहीं मापा गया: सतह का %2।</translation>
    </message>
    <message>
        <source>Largest part that was not measured: %1.</source>
        <translation>सबसे बड़ा अनमापा भाग: %1।</translation>
    </message>
    <message>
        <source>Nothing is open.</source>
        <translation>कुछ खुला नहीं है।</translation>
    </message>
    <message>
        <source>Moved.</source>
        <translation>खिसकाया गया।</translation>
    </message>
    <message>
        <source>Back at the old window.</source>
        <translation>पुरानी विंडो पर वापस।</translation>
    </message>
    <message>
        <source>Touching: %1, height %2.</source>
        <translation>स्पर्श: %1, ऊँचाई %2।</translation>
    </message>
    <message>
        <source>Touching: %1, %3 high.</source>
        <translation>स्पर्श: %1, ऊँचाई %3।</translation>
    </message>
    <message>
        <source>Touching: %1, on the ground.</source>
        <translation>स्पर्श: %1, आधार पर।</translation>
    </message>
    <message>
        <source>Touching: %1, %3 deep.</source>
        <translation>स्पर्श: %1, गहराई %3।</translation>
    </message>
    <message>
        <source>In the air: %1.</source>
        <translation>हवा में: %1।</translation>
    </message>
    <message>
        <source>Beside the relief.</source>
        <translation>आकृति के बाहर।</translation>
    </message>
    <message>
        <source>Measured here.</source>
        <translation>यहाँ मापा गया है।</translation>
    </message>
    <message>
        <source>Not measured here: %1.</source>
        <translation>यहाँ मापा नहीं गया: %1।</translation>
    </message>
    <message>
        <source>Not measured here.</source>
        <translation>यहाँ मापा नहीं गया।</translation>
    </message>
    <message>
        <source>%1 from the left edge.</source>
        <translation>बाएँ किनारे से %1।</translation>
    </message>
    <message>
        <source>%2 from the left edge.</source>
        <translation>बाएँ किनारे से %2।</translation>
    </message>
    <message>
        <source>%1 from the bottom edge.</source>
        <translation>निचले किनारे से %1।</translation>
    </message>
    <message>
        <source>%2 from the bottom edge.</source>
        <translation>निचले किनारे से %2।</translation>
    </message>
    <message>
        <source>1 mm of hand is %1 of relief.</source>
        <translation>हाथ का 1 mm आकृति का %1 है।</translation>
    </message>
    <message>
        <source>One centimetre of hand: %2 of relief.</source>
        <translation>हाथ का एक सेंटीमीटर: आकृति के %2।</translation>
    </message>
    <message>
        <source>Samples are %1 apart.</source>
        <translation>नमूने %1 दूर हैं।</translation>
    </message>
    <message>
        <source>Samples are %2 apart.</source>
        <translation>नमूने %2 दूर हैं।</translation>
    </message>
    <message>
        <source>Speech is not available: %1. Texts appear here. Install speech-dispatcher or espeak-ng, or choose the screen reader in the panel Voice.</source>
        <translation>वाणी उपलब्ध नहीं है: %1। पाठ यहाँ दिखते हैं। speech-dispatcher या espeak-ng स्थापित करें, या आवाज़ पैनल में स्क्रीन रीडर चुनें।</translation>
    </message>
    <message>
        <source>Speech is not available.</source>
        <translation>वाणी उपलब्ध नहीं है।</translation>
    </message>
    <message>
        <source>no speech service listens at %1</source>
        <translation>%1 पर कोई वाणी सेवा नहीं सुन रही</translation>
    </message>
    <message>
        <source>the speech service does not answer</source>
        <translation>वाणी सेवा उत्तर नहीं देती</translation>
    </message>
    <message>
        <source>the speech service ended the connection</source>
        <translation>वाणी सेवा ने संपर्क समाप्त कर दिया</translation>
    </message>
    <message>
        <source>the speech service says &quot;%1&quot;</source>
        <translation>वाणी सेवा कहती है “%1”</translation>
    </message>
    <message>
        <source>the program %1 cannot be started</source>
        <translation>प्रोग्राम %1 शुरू नहीं हो सकता</translation>
    </message>
    <message>
        <source>the program %1 ended with an error</source>
        <translation>प्रोग्राम %1 त्रुटि के साथ समाप्त हुआ</translation>
    </message>
    <message>
        <source>This is the voice of relievo.</source>
        <translation>यह relievo की आवाज़ है।</translation>
    </message>
    <message>
        <source>Nothing was said yet.</source>
        <translation>अभी तक कुछ नहीं कहा गया।</translation>
    </message>
    <message>
        <source>Roughest part: %1 (%2 off its surroundings).</source>
        <translation>सबसे खुरदरा भाग: %1 (अपने आस-पास से %2 का अंतर)।</translation>
    </message>
    <message>
        <source>Smoothest part: %1 (%2 off its surroundings).</source>
        <translation>सबसे चिकना भाग: %1 (अपने आस-पास से %2 का अंतर)।</translation>
    </message>
    <message>
        <source>Measured here, but too steep to trust.</source>
        <translation>यहाँ मापा गया, पर भरोसे के लिए बहुत खड़ा है।</translation>
    </message>
    <message>
        <source>The plug-in %1 is not run: others may change %2. Take that right from them (&apos;chmod go-w&apos;), or keep the plug-in where only you write, then try again.</source>
        <translation>प्लग-इन %1 नहीं चलाया जाता: दूसरे %2 को बदल सकते हैं। उनसे यह अधिकार हटाएँ (&apos;chmod go-w&apos;), या प्लग-इन को वहाँ रखें जहाँ केवल आप लिखते हैं, फिर दोबारा प्रयास करें।</translation>
    </message>
    <message>
        <source>{1|%1 newton|%1 newtons}</source>
        <translation>%1 न्यूटन</translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation>%1 न्यूटन</translation>
    </message>
    <message>
        <source>%1 newtons per millimetre</source>
        <translation>%1 न्यूटन प्रति मिलीमीटर</translation>
    </message>
    <message>
        <source>{1|%1 second|%1 seconds}</source>
        <translation>%1 सेकंड</translation>
    </message>
    <message>
        <source>%1 seconds</source>
        <translation>%1 सेकंड</translation>
    </message>
    <message>
        <source>{1|%1 degree|%1 degrees}</source>
        <translation>%1 डिग्री</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 डिग्री</translation>
    </message>
    <message>
        <source>%1 hertz</source>
        <translation>%1 हर्ट्ज़</translation>
    </message>
    <message>
        <source>%1 square millimetres</source>
        <translation>%1 वर्ग मिलीमीटर</translation>
    </message>
    <message>
        <source>%1 cubic millimetres</source>
        <translation>%1 घन मिलीमीटर</translation>
    </message>
    <message>
        <source>minus %1</source>
        <translation>ऋण %1</translation>
    </message>
    <message>
        <source>by</source>
        <translation>गुणा</translation>
    </message>
    <message>
        <source>Volume %1 percent.</source>
        <translation>आवाज़ %1 प्रतिशत।</translation>
    </message>
    <message>
        <source>The sound is a WAV file, and &apos;%1&apos; does not end in .wav. Nothing was written. Choose another name.</source>
        <translation>ध्वनि WAV फ़ाइल होती है, और &apos;%1&apos; .wav पर समाप्त नहीं होता। कुछ नहीं लिखा गया। दूसरा नाम चुनें।</translation>
    </message>
    <message>
        <source>A WAV file holds %1 hours of sound, and this would be %2. Nothing was written. Choose a part with --from and --to.</source>
        <translation>WAV फ़ाइल में %1 घंटे की ध्वनि समाती है, और यह %2 होती। कुछ नहीं लिखा गया। --from और --to से एक भाग चुनें।</translation>
    </message>
    <message>
        <source>Say it again</source>
        <translation>फिर से कहें</translation>
    </message>
    <message>
        <source>Louder</source>
        <translation>और तेज़</translation>
    </message>
    <message>
        <source>Softer</source>
        <translation>और धीमा</translation>
    </message>
    <message>
        <source>Now, for 20 seconds: Plus: louder. Minus: softer. Centre: say it again. Forward: back.</source>
        <translation>अब 20 सेकंड तक: प्लस: और तेज़। माइनस: और धीमा। बीच: फिर से कहें। आगे: वापस।</translation>
    </message>
    <message>
        <source>The Haply device is not in use.</source>
        <translation>Haply उपकरण उपयोग में नहीं है।</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service does not answer at %1. Start it, by the Haply Hub or by &apos;systemctl start haply-inverse-service&apos;, then try again.</source>
        <translation>Haply की Inverse Service %1 पर उत्तर नहीं देती। उसे Haply Hub से या &apos;systemctl start haply-inverse-service&apos; से चालू करें, फिर दोबारा कोशिश करें।</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service does not answer.</source>
        <translation>Haply की Inverse Service उत्तर नहीं देती।</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service at %1 went away. Forces are off; it is looked for until it is back.</source>
        <translation>%1 पर Haply की Inverse Service चली गई। बल बंद हैं; उसके लौटने तक उसे खोजा जाता है।</translation>
    </message>
    <message>
        <source>The Haply device went away. Forces are off.</source>
        <translation>Haply उपकरण चला गया। बल बंद हैं।</translation>
    </message>
    <message>
        <source>What answers at %1 is not Haply&apos;s Inverse Service, or does not tell its version (%2). Nothing is sent to it. If the service has another port, name it by RELIEVO_HAPLY_SERVICE.</source>
        <translation>%1 पर जो उत्तर देता है वह Haply की Inverse Service नहीं है, या अपना संस्करण नहीं बताता (%2)। उसे कुछ नहीं भेजा जाता। यदि सेवा का पोर्ट दूसरा है, तो उसे RELIEVO_HAPLY_SERVICE में लिखें।</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service has version %1; relievo needs 3.1 or a newer 3. Bring it up to date by the Haply Hub, then try again.</source>
        <translation>Haply की Inverse Service का संस्करण %1 है; relievo को 3.1 या नया 3 चाहिए। Haply Hub से उसे अद्यतन करें, फिर दोबारा कोशिश करें।</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service runs, but sees no Inverse3 or Minverse. Plug it in and switch it on.</source>
        <translation>Haply की Inverse Service चल रही है, पर उसे कोई Inverse3 या Minverse नहीं दिखता। उसे जोड़ें और चालू करें।</translation>
    </message>
    <message>
        <source>No Haply device is plugged in.</source>
        <translation>कोई Haply उपकरण जुड़ा नहीं है।</translation>
    </message>
    <message>
        <source>The Haply device went away. Forces are off; plug it in again and switch it on.</source>
        <translation>Haply उपकरण चला गया। बल बंद हैं; उसे फिर जोड़ें और चालू करें।</translation>
    </message>
    <message>
        <source>%1 is not there. There is: %2.</source>
        <translation>%1 यहाँ नहीं है। यहाँ है: %2।</translation>
    </message>
    <message>
        <source>There are several Haply devices: %1. Choose one of them, as haply:ID.</source>
        <translation>कई Haply उपकरण हैं: %1। उनमें से एक चुनें, haply:ID के रूप में।</translation>
    </message>
    <message>
        <source>Setting up the Haply device …</source>
        <translation>Haply उपकरण तैयार किया जा रहा है …</translation>
    </message>
    <message>
        <source>The Haply device is not calibrated. Put its grip into the inkwell and wait until the light is steady.</source>
        <translation>Haply उपकरण अंशांकित नहीं है। उसकी मूठ को आधार-खाँचे में रखें और बत्ती के स्थिर होने तक रुकें।</translation>
    </message>
    <message>
        <source>Put the grip into the inkwell.</source>
        <translation>मूठ को आधार-खाँचे में रखें।</translation>
    </message>
    <message>
        <source>The Haply device has no power for its motors. Plug in its power supply, and release its emergency stop if it has one.</source>
        <translation>Haply उपकरण की मोटरों को बिजली नहीं मिल रही। उसका बिजली-अडैप्टर जोड़ें, और यदि उसमें आपात-रोक है तो उसे छोड़ें।</translation>
    </message>
    <message>
        <source>The Haply device has no power.</source>
        <translation>Haply उपकरण में बिजली नहीं है।</translation>
    </message>
    <message>
        <source>The Haply device is not ready: its service has not started it. Look at it in the Haply Hub.</source>
        <translation>Haply उपकरण तैयार नहीं है: उसकी सेवा ने उसे चालू नहीं किया। Haply Hub में देखें।</translation>
    </message>
    <message>
        <source>Another program changes how the Haply device is set up, or its service does not tell how it is. Forces are off. Close the other program; it is tried again in 10 seconds.</source>
        <translation>कोई दूसरा प्रोग्राम Haply उपकरण की सेटिंग बदलता है, या उसकी सेवा उसे नहीं बताती। बल बंद हैं। दूसरा प्रोग्राम बंद करें; 10 सेकंड में फिर कोशिश होगी।</translation>
    </message>
    <message>
        <source>Another program changes the Haply device. Forces are off.</source>
        <translation>कोई दूसरा प्रोग्राम Haply उपकरण बदल रहा है। बल बंद हैं।</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service does not obey forces: %1 were ordered, and it tells of %2. Forces are off. Report this with the version of the service, %3.</source>
        <translation>Haply की Inverse Service बल का पालन नहीं करती: %1 माँगे गए थे, और वह %2 बताती है। बल बंद हैं। सेवा के संस्करण %3 के साथ इसकी सूचना दें।</translation>
    </message>
    <message>
        <source>The Haply service does not obey forces.</source>
        <translation>Haply सेवा बल का पालन नहीं करती।</translation>
    </message>
    <message>
        <source>Another program pushes the Haply device, too. Forces are off. Close that program.</source>
        <translation>कोई दूसरा प्रोग्राम भी Haply उपकरण को धकेल रहा है। बल बंद हैं। वह प्रोग्राम बंद करें।</translation>
    </message>
    <message>
        <source>Another program pushes the Haply device. Forces are off.</source>
        <translation>कोई दूसरा प्रोग्राम Haply उपकरण को धकेल रहा है। बल बंद हैं।</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service does not answer any more. Forces are off; it is tried again.</source>
        <translation>Haply की Inverse Service अब उत्तर नहीं देती। बल बंद हैं; फिर कोशिश की जाती है।</translation>
    </message>
    <message>
        <source>The Haply device does not answer. Forces are off.</source>
        <translation>Haply उपकरण उत्तर नहीं देता। बल बंद हैं।</translation>
    </message>
    <message>
        <source>Haply device ready.</source>
        <translation>Haply उपकरण तैयार है।</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no Haply device. Write haply:ID as &apos;relievo devices&apos; lists it, or haply for the only one.</source>
        <translation>&quot;%1&quot; किसी Haply उपकरण का नाम नहीं है। haply:ID लिखें जैसा &apos;relievo devices&apos; बताता है, या एकमात्र के लिए haply।</translation>
    </message>
    <message>
        <source>RELIEVO_HAPLY_SERVICE is &quot;%1&quot;, which is no port and no address with a port. Write 10001 or 127.0.0.1:10001, or unset it.</source>
        <translation>RELIEVO_HAPLY_SERVICE &quot;%1&quot; है, जो न पोर्ट है न पोर्ट वाला पता। 10001 या 127.0.0.1:10001 लिखें, या उसे हटा दें।</translation>
    </message>
    <message>
        <source>This relievo was built without Boost, which it needs to speak with Haply&apos;s Inverse Service. Install libboost-dev and build it again.</source>
        <translation>यह relievo Boost के बिना बना है, जो Haply की Inverse Service से बात करने के लिए चाहिए। libboost-dev स्थापित करें और इसे फिर बनाएँ।</translation>
    </message>
    <message>
        <source>The Haply device&apos;s thread could not be started: %1.</source>
        <translation>Haply उपकरण का थ्रेड शुरू नहीं हो सका: %1।</translation>
    </message>
    <message>
        <source>The Haply device was not ready within %1, and nothing was recorded. %2</source>
        <translation>Haply उपकरण %1 के भीतर तैयार नहीं हुआ, और कुछ भी रिकॉर्ड नहीं हुआ। %2</translation>
    </message>
    <message>
        <source>A way that a hand is led along needs two different places, three of a closed one, in the order of their times.</source>
        <translation>जिस रास्ते पर हाथ को ले चला जाए उसमें दो अलग स्थान चाहिए, बंद रास्ते में तीन, समय के क्रम में।</translation>
    </message>
    <message>
        <source>The way that the hand was led along is damaged in this recording: it cannot be replayed.</source>
        <translation>जिस रास्ते पर हाथ को ले चला गया था वह इस रिकॉर्डिंग में बिगड़ा हुआ है: इसे दोहराया नहीं जा सकता।</translation>
    </message>
    <message>
        <source>--guide leads a hand. Give one that can be led, with --device virtual:light, virtual:relaxed or virtual:firm, and leave --safety on.</source>
        <translation>--guide हाथ को ले चलता है। ऐसा हाथ दें जिसे ले चला जा सके, --device virtual:light, virtual:relaxed या virtual:firm से, और --safety चालू रहने दें।</translation>
    </message>
    <message>
        <source>There is no outline in this window to be led along: none that was measured all round. Choose another region, or give --guide a stroke.</source>
        <translation>इस विंडो में ले चलने के लिए कोई रूपरेखा नहीं है: कोई भी चारों ओर से मापी नहीं गई। दूसरा क्षेत्र चुनें, या --guide को हाथ का रास्ता दें।</translation>
    </message>
    <message>
        <source>There is nothing to touch along. Give --stroke FILE.csv, or --guide.</source>
        <translation>स्पर्श करने का कोई रास्ता नहीं है। --stroke FILE.csv या --guide दें।</translation>
    </message>
    <message>
        <source>Guiding along %1. You lead: push against it, or press a button, and it lets go.</source>
        <translation>%1 के साथ-साथ ले चल रहा हूँ। आप तय करते हैं: विरोध में धकेलें या कोई बटन दबाएँ, तो मैं छोड़ दूँगा।</translation>
    </message>
    <message>
        <source>Guiding along %1, you lead.</source>
        <translation>%1 के साथ-साथ ले चल रहा हूँ, आप तय करते हैं।</translation>
    </message>
    <message>
        <source>the outline of a raised area</source>
        <translation>एक उभरे भाग की रूपरेखा</translation>
    </message>
    <message>
        <source>the outline of a sunken area</source>
        <translation>एक धँसे भाग की रूपरेखा</translation>
    </message>
    <message>
        <source>the border of the object</source>
        <translation>वस्तु के किनारे</translation>
    </message>
    <message>
        <source>a recorded way</source>
        <translation>एक रिकॉर्ड किए रास्ते</translation>
    </message>
    <message>
        <source>You lead.</source>
        <translation>अब आप ले चलें।</translation>
    </message>
    <message>
        <source>The guide has arrived.</source>
        <translation>मार्गदर्शन पूरा हुआ।</translation>
    </message>
    <message>
        <source>The hand is at the marker.</source>
        <translation>हाथ निशान पर है।</translation>
    </message>
    <message>
        <source>The guide is off.</source>
        <translation>मार्गदर्शन बंद है।</translation>
    </message>
    <message>
        <source>The guide is off: the window is another one.</source>
        <translation>मार्गदर्शन बंद है: विंडो दूसरी है।</translation>
    </message>
    <message>
        <source>There is no outline here to be led along.</source>
        <translation>यहाँ ले चलने के लिए कोई रूपरेखा नहीं है।</translation>
    </message>
    <message>
        <source>The guide needs the forces. Press F5 to switch them on, then ask for it again.</source>
        <translation>मार्गदर्शन के लिए बल चाहिए। F5 से उन्हें चालू करें, फिर उसे दोबारा माँगें।</translation>
    </message>
    <message>
        <source>The guide needs the forces. Switch them on first.</source>
        <translation>मार्गदर्शन के लिए बल चाहिए। पहले उन्हें चालू करें।</translation>
    </message>
    <message>
        <source>The guide needs a device that can move the hand.</source>
        <translation>मार्गदर्शन के लिए ऐसा उपकरण चाहिए जो हाथ को हिला सके।</translation>
    </message>
    <message>
        <source>Guide along the outline</source>
        <translation>रूपरेखा के साथ ले चलना</translation>
    </message>
    <message>
        <source>Introduction: five shapes under the hand, one after the other. Next shape (Ctrl+Alt+N) or the button Forward goes on at once, Introduction again ends it.</source>
        <translation>परिचय: हाथ के नीचे एक के बाद एक पाँच आकार। अगला आकार (Ctrl+Alt+N) या बटन आगे तुरंत बढ़ाता है, परिचय दोबारा चुनना उसे समाप्त करता है।</translation>
    </message>
    <message>
        <source>Introduction: five shapes. The button Forward goes on.</source>
        <translation>परिचय: पाँच आकार। बटन आगे अगले पर ले जाता है।</translation>
    </message>
    <message>
        <source>I switch the forces on now. They start softly.</source>
        <translation>अब मैं बल चालू करता हूँ। वे धीरे से शुरू होते हैं।</translation>
    </message>
    <message>
        <source>There is a flat plate. Push towards it and slide.</source>
        <translation>एक सपाट पट्टी है। उस पर दबाएँ और फिसलाएँ।</translation>
    </message>
    <message>
        <source>Now there is a bump. Find it.</source>
        <translation>अब एक उभार है। उसे खोजें।</translation>
    </message>
    <message>
        <source>Now there is a step. Go over its edge.</source>
        <translation>अब एक सीढ़ी है। उसके किनारे के पार जाएँ।</translation>
    </message>
    <message>
        <source>Now there are waves. Stroke across them.</source>
        <translation>अब लहरें हैं। उनके आर-पार हाथ फेरें।</translation>
    </message>
    <message>
        <source>Now there is a groove. Find it and follow it.</source>
        <translation>अब एक खाँचा है। उसे खोजें और उसके साथ चलें।</translation>
    </message>
    <message>
        <source>The bump is a little right and above the middle.</source>
        <translation>उभार बीच से थोड़ा दाएँ और ऊपर है।</translation>
    </message>
    <message>
        <source>The edge is in the middle. Go from left to right.</source>
        <translation>किनारा बीच में है। बाएँ से दाएँ जाएँ।</translation>
    </message>
    <message>
        <source>Go from left to right while you touch.</source>
        <translation>स्पर्श करते हुए बाएँ से दाएँ जाएँ।</translation>
    </message>
    <message>
        <source>The groove runs from left to right, above the middle.</source>
        <translation>खाँचा बीच से ऊपर, बाएँ से दाएँ जाता है।</translation>
    </message>
    <message>
        <source>Push the grip away from you until it meets the plate.</source>
        <translation>ग्रिप को अपने से दूर धकेलें, जब तक वह पट्टी से न लगे।</translation>
    </message>
    <message>
        <source>Yes.</source>
        <translation>हाँ।</translation>
    </message>
    <message>
        <source>Let us go on.</source>
        <translation>आगे चलते हैं।</translation>
    </message>
    <message>
        <source>The introduction has ended. The relief is under the hand again.</source>
        <translation>परिचय समाप्त हुआ। उभार फिर से हाथ के नीचे है।</translation>
    </message>
    <message>
        <source>The introduction is off. The relief is under the hand again.</source>
        <translation>परिचय बंद है। उभार फिर से हाथ के नीचे है।</translation>
    </message>
    <message>
        <source>Gamepads that are no HID devices cannot be used: this program was built without the system&apos;s header linux/input.h.</source>
        <translation>जो गेमपैड HID उपकरण नहीं हैं, उनका उपयोग नहीं हो सकता: यह प्रोग्राम सिस्टम की हेडर फ़ाइल linux/input.h के बिना बनाया गया था।</translation>
    </message>
    <message>
        <source>%1&apos;s library was not found, or cannot be used (%2)</source>
        <translation>%1 की लाइब्रेरी नहीं मिली, या उपयोग नहीं हो सकती (%2)</translation>
    </message>
    <message>
        <source>Look or touch</source>
        <translation>देखना या स्पर्श</translation>
    </message>
    <message>
        <source>A pixel size is above 0 mm, and a height scale is not 0 mm.</source>
        <translation>पिक्सेल का आकार 0 mm से अधिक होता है, और ऊँचाई का पैमाना 0 mm नहीं होता।</translation>
    </message>
    <message>
        <source>--every thins what is read into memory; a map by tiles (--memory) takes all points. Leave one of the two out.</source>
        <translation>--every उसे विरल करता है जो स्मृति में पढ़ा जाता है; टाइलों वाला मानचित्र (--memory) सभी बिंदु लेता है। दोनों में से एक छोड़ दें।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no participant code: 1 to 32 letters, digits, &apos;-&apos; and &apos;_&apos;, and no name. Nothing was begun.</source>
        <translation>&apos;%1&apos; प्रतिभागी कोड नहीं है: 1 से 32 अक्षर, अंक, &apos;-&apos; और &apos;_&apos;, और कोई नाम नहीं। कुछ शुरू नहीं हुआ।</translation>
    </message>
    <message>
        <source>A sitting needs a note on the participant&apos;s consent. Nothing was begun.</source>
        <translation>सत्र के लिए प्रतिभागी की सहमति पर टिप्पणी चाहिए। कुछ शुरू नहीं हुआ।</translation>
    </message>
    <message>
        <source>A study has 2 to 26 conditions, each shown 1 to 100 times; this has {1|%1 condition|%1 conditions}, %2 times. Nothing was begun.</source>
        <translation>अध्ययन में 2 से 26 शर्तें होती हैं, हर एक 1 से 100 बार; इसमें %1 शर्तें हैं, %2 बार। कुछ शुरू नहीं हुआ।</translation>
    </message>
    <message>
        <source>No folder for the sitting could be made in %1: %2. Nothing was begun. Choose another folder.</source>
        <translation>%1 में सत्र का फ़ोल्डर नहीं बन सका: %2। कुछ शुरू नहीं हुआ। दूसरा फ़ोल्डर चुनें।</translation>
    </message>
    <message>
        <source>The profile talk halves the colours&apos; size, which mixes the two eyes of an anaglyph and of alternate rows. Choose the profile anaglyph or archive. Nothing was made.</source>
        <translation>प्रोफ़ाइल talk रंगों का आकार आधा करती है, जिससे एनाग्लिफ़ की और बारी-बारी की पंक्तियों की दोनों आँखें मिल जाती हैं। प्रोफ़ाइल anaglyph या archive चुनें। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>Cannot read %1: its %2 points need about %3 of memory; %4 are free. Nothing was loaded. Load one point in %5 (--every %5), about %6, or make the map by tiles (--memory).</source>
        <translation>%1 नहीं पढ़ी जा सकती: इसके %2 बिंदुओं को लगभग %3 स्मृति चाहिए; %4 खाली है। कुछ लोड नहीं हुआ। %5 में से एक बिंदु लोड करें (--every %5), लगभग %6, या मानचित्र टाइलों से बनाएँ (--memory)।</translation>
    </message>
    <message>
        <source>The scan needs about %3 of memory, and %4 are free. Press Control and Enter to load one point in %5.</source>
        <translation>स्कैन को लगभग %3 स्मृति चाहिए, और %4 खाली है। %5 में से एक बिंदु लोड करने के लिए कंट्रोल और एंटर दबाएँ।</translation>
    </message>
    <message>
        <source>Cannot read %1: its %2 corners need about %3 of memory; %4 are free. Nothing was loaded. Close other programs, or simplify the mesh first.</source>
        <translation>%1 नहीं पढ़ी जा सकती: इसके %2 कोनों को लगभग %3 स्मृति चाहिए; %4 खाली है। कुछ लोड नहीं हुआ। दूसरे प्रोग्राम बंद करें, या पहले जाल को सरल करें।</translation>
    </message>
    <message>
        <source>--every: %1 has faces, which need all of its points. Nothing was loaded. Leave the option out, or simplify the mesh first.</source>
        <translation>--every: %1 में फलक हैं, जिन्हें इसके सभी बिंदु चाहिए। कुछ लोड नहीं हुआ। विकल्प छोड़ दें, या पहले जाल को सरल करें।</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>चिह्न</translation>
    </message>
    <message>
        <source>Edges: the hand reached %1 mm right, %2 left, %3 up, %4 down, %5 out and %6 in.</source>
        <translation>किनारे: हाथ %1 mm दाएँ, %2 बाएँ, %3 ऊपर, %4 नीचे, %5 बाहर और %6 अंदर तक पहुँचा।</translation>
    </message>
    <message>
        <source>Edges: the hand reached %1 mm right, %2 left, %3 up, %4 down, %5 out and %6 in; not to the end: %7.</source>
        <translation>किनारे: हाथ %1 mm दाएँ, %2 बाएँ, %3 ऊपर, %4 नीचे, %5 बाहर और %6 अंदर तक पहुँचा; अंत तक नहीं: %7।</translation>
    </message>
    <message>
        <source>right side</source>
        <translation>दाईं ओर</translation>
    </message>
    <message>
        <source>left side</source>
        <translation>बाईं ओर</translation>
    </message>
    <message>
        <source>up</source>
        <translation>ऊपर</translation>
    </message>
    <message>
        <source>down</source>
        <translation>नीचे</translation>
    </message>
    <message>
        <source>out</source>
        <translation>बाहर</translation>
    </message>
    <message>
        <source>in</source>
        <translation>अंदर</translation>
    </message>
    <message>
        <source>Move the grip to its end on every side and press each of the four buttons.</source>
        <translation>पकड़ को हर ओर अंत तक ले जाएँ और चारों बटनों में से हर एक दबाएँ।</translation>
    </message>
    <message>
        <source>Move the grip to its end on every side and press each of the four buttons. Still missing: %1.</source>
        <translation>पकड़ को हर ओर अंत तक ले जाएँ और चारों बटनों में से हर एक दबाएँ। अभी बाक़ी: %1।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is %2; this version reads scans as %3, and rasters as GeoTIFF, TIFF, PNG or ESRI ASCII grid. Convert it to one of these, or choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह %2 है; यह संस्करण स्कैन %3 के रूप में और रास्टर GeoTIFF, TIFF, PNG या ESRI ASCII ग्रिड के रूप में पढ़ता है। इसे इनमें से किसी में बदलें या दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot publish to %1: there is something already. It was left as it is. Give a folder that is empty or not there yet.</source>
        <translation>%1 में प्रकाशित नहीं किया जा सकता: वहाँ पहले से कुछ है। वह जैसा था वैसा ही है। ऐसा फ़ोल्डर दें जो खाली हो या अभी न हो।</translation>
    </message>
    <message>
        <source>%1 is no map by tiles, and so it cannot be published. Nothing was written. Make one with relievo depthmap --memory, and publish that.</source>
        <translation>%1 टाइलों वाला मानचित्र नहीं है, इसलिए प्रकाशित नहीं किया जा सकता। कुछ नहीं लिखा गया। relievo depthmap --memory से एक बनाएँ और उसे प्रकाशित करें।</translation>
    </message>
    <message>
        <source>The published map %1 has no file %2 (%3). Look at the address, or publish the map again.</source>
        <translation>प्रकाशित मानचित्र %1 में फ़ाइल %2 नहीं है (%3)। पता जाँचें, या मानचित्र फिर से प्रकाशित करें।</translation>
    </message>
    <message>
        <source>The file %2 of the published map %1 is damaged: it is not what was published. It was not used. Publish the map again.</source>
        <translation>प्रकाशित मानचित्र %1 की फ़ाइल %2 क्षतिग्रस्त है: यह वह नहीं है जो प्रकाशित हुआ था। इसका उपयोग नहीं किया गया। मानचित्र फिर से प्रकाशित करें।</translation>
    </message>
    <message>
        <source>A tile of level %2 of the published map %1 is damaged: its checksum is not the one that was published (%3). It was not used. Publish the map again.</source>
        <translation>प्रकाशित मानचित्र %1 के स्तर %2 की एक टाइल क्षतिग्रस्त है: उसका चेकसम वह नहीं है जो प्रकाशित हुआ था (%3)। उसका उपयोग नहीं किया गया। मानचित्र फिर से प्रकाशित करें।</translation>
    </message>
    <message>
        <source>The map %1 cannot be fetched now: %2. Look at the network, and try again.</source>
        <translation>मानचित्र %1 अभी नहीं लाया जा सकता: %2। नेटवर्क जाँचें और फिर से प्रयास करें।</translation>
    </message>
    <message>
        <source>There is no published map at %1: its map.json is none of this version. Give the address of a folder that relievo publish made.</source>
        <translation>%1 पर कोई प्रकाशित मानचित्र नहीं है: वहाँ की map.json इस संस्करण की नहीं है। ऐसे फ़ोल्डर का पता दें जिसे relievo publish ने बनाया हो।</translation>
    </message>
    <message>
        <source>%1 gives no answer. The map is shown as it was when it was last opened, with the tiles that were kept.</source>
        <translation>%1 उत्तर नहीं देता। मानचित्र वैसा दिखाया जाता है जैसा पिछली बार खोलने पर था, रखी हुई टाइलों के साथ।</translation>
    </message>
    <message>
        <source>The server gives no answer. The map is shown as it was kept.</source>
        <translation>सर्वर उत्तर नहीं देता। मानचित्र वैसा दिखाया जाता है जैसा रखा गया था।</translation>
    </message>
    <message>
        <source>Coarser until the tiles are here.</source>
        <translation>टाइलें आने तक कम बारीक।</translation>
    </message>
    <message>
        <source>%1 gives no answer. What is here can be seen and felt; the rest is asked for again and again.</source>
        <translation>%1 उत्तर नहीं देता। जो यहाँ है उसे देखा और महसूस किया जा सकता है; शेष के लिए बार-बार पूछा जाता है।</translation>
    </message>
    <message>
        <source>The server gives no answer. What is here can be felt.</source>
        <translation>सर्वर उत्तर नहीं देता। जो यहाँ है उसे महसूस किया जा सकता है।</translation>
    </message>
    <message>
        <source>%1 answers again.</source>
        <translation>%1 फिर उत्तर देता है।</translation>
    </message>
    <message>
        <source>The server answers again.</source>
        <translation>सर्वर फिर उत्तर देता है।</translation>
    </message>
    <message>
        <source>%1 is not JSON: line %2 cannot be read.</source>
        <translation>%1 JSON नहीं है: पंक्ति %2 पढ़ी नहीं जा सकती।</translation>
    </message>
    <message>
        <source>%1 is no exhibit: it does not begin with &quot;relievo_exhibit&quot;: 1.</source>
        <translation>%1 प्रदर्शनी नहीं है: फ़ाइल &quot;relievo_exhibit&quot;: 1 से शुरू नहीं होती।</translation>
    </message>
    <message>
        <source>%1 is an exhibit of version %2. This program reads version 1.</source>
        <translation>%1 संस्करण %2 की प्रदर्शनी है। यह प्रोग्राम संस्करण 1 पढ़ता है।</translation>
    </message>
    <message>
        <source>%1 cannot be shown as an exhibit. %2</source>
        <translation>%1 प्रदर्शनी के रूप में नहीं दिखाई जा सकती। %2</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 नहीं है।</translation>
    </message>
    <message>
        <source>%1 means nothing here. There are %2.</source>
        <translation>%1 का यहाँ कोई अर्थ नहीं है। यहाँ हो सकते हैं: %2।</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1 को %2 होना चाहिए।</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>एक पाठ</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>एक संख्या</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>एक पूर्ण संख्या</translation>
    </message>
    <message>
        <source>a list in square brackets</source>
        <translation>वर्गाकार कोष्ठकों में एक सूची</translation>
    </message>
    <message>
        <source>a group in braces</source>
        <translation>धनुकोष्ठकों में एक समूह</translation>
    </message>
    <message>
        <source>%1 is %2; it must be from %3 to %4.</source>
        <translation>%1 का मान %2 है; वह %3 से %4 तक होना चाहिए।</translation>
    </message>
    <message>
        <source>%1: relievo does not speak &apos;%2&apos;. It speaks %3.</source>
        <translation>%1: relievo &apos;%2&apos; नहीं बोलता। वह %3 बोलता है।</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; stands there twice.</source>
        <translation>%1: &apos;%2&apos; वहाँ दो बार है।</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 खाली है।</translation>
    </message>
    <message>
        <source>%1 has %2 entries; it can have %3.</source>
        <translation>%1 में %2 प्रविष्टियाँ हैं; %3 हो सकती हैं।</translation>
    </message>
    <message>
        <source>%1: there is no file %2.</source>
        <translation>%1: फ़ाइल %2 नहीं है।</translation>
    </message>
    <message>
        <source>%1 has no words.</source>
        <translation>%1 में कोई शब्द नहीं है।</translation>
    </message>
    <message>
        <source>%1 has no text for the language &apos;%2&apos;.</source>
        <translation>%1 में भाषा &apos;%2&apos; का पाठ नहीं है।</translation>
    </message>
    <message>
        <source>%1 has a text for &apos;%2&apos;, which is none of the exhibit&apos;s languages (%3).</source>
        <translation>%1 में &apos;%2&apos; का पाठ है, जो प्रदर्शनी की भाषाओं (%3) में नहीं है।</translation>
    </message>
    <message>
        <source>%1 has %2 words; it can have %3.</source>
        <translation>%1 में %2 शब्द हैं; %3 हो सकते हैं।</translation>
    </message>
    <message>
        <source>staff_pin must hold a salt of up to 64 characters and 64 hexadecimal digits. &apos;relievo exhibit pin&apos; makes both.</source>
        <translation>staff_pin में 64 वर्णों तक का salt और 64 षोडशाधारी अंक होने चाहिए। &apos;relievo exhibit pin&apos; दोनों बनाता है।</translation>
    </message>
    <message>
        <source>The counts in %1 could not be read. They were set aside as %2, and counting begins anew.</source>
        <translation>%1 की गणनाएँ पढ़ी नहीं जा सकीं। वे %2 के रूप में अलग रखी गईं, और गिनती नए सिरे से शुरू होती है।</translation>
    </message>
    <message>
        <source>A PIN has 4 to 12 digits, one line on standard input. Nothing was made.</source>
        <translation>PIN में 4 से 12 अंक होते हैं, मानक इनपुट पर एक पंक्ति। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>exhibit %1 needs the file of the exhibit.</source>
        <translation>exhibit %1 को प्रदर्शनी की फ़ाइल चाहिए।</translation>
    </message>
    <message>
        <source>exhibit pin takes no file. It prints what belongs into one.</source>
        <translation>exhibit pin कोई फ़ाइल नहीं लेता। वह वही छापता है जो फ़ाइल में होना चाहिए।</translation>
    </message>
    <message>
        <source>The exhibit ended %1 times within %2 minutes and was not started again. %3 says when and how.</source>
        <translation>प्रदर्शनी %2 मिनट में %1 बार बंद हुई और फिर शुरू नहीं की गई। कब और कैसे, यह %3 में है।</translation>
    </message>
    <message>
        <source>Welcome. You can touch reliefs here.</source>
        <translation>स्वागत है। यहाँ आप उभारों को छू सकते हैं।</translation>
    </message>
    <message>
        <source>In front of you is a grip with four buttons.</source>
        <translation>आपके सामने चार बटनों वाला एक हैंडल है।</translation>
    </message>
    <message>
        <source>For English press the middle button.</source>
        <translation>हिन्दी के लिए बीच का बटन दबाएँ।</translation>
    </message>
    <message>
        <source>The button Forward: another language.</source>
        <translation>आगे वाला बटन: दूसरी भाषा।</translation>
    </message>
    <message>
        <source>Plus is louder, Minus is softer.</source>
        <translation>प्लस से तेज़, माइनस से धीमा।</translation>
    </message>
    <message>
        <source>Object %1 of %2: %3.</source>
        <translation>%2 में से वस्तु %1: %3।</translation>
    </message>
    <message>
        <source>The middle button: touch it.</source>
        <translation>बीच का बटन: इसे छुएँ।</translation>
    </message>
    <message>
        <source>Forward: the next one. Forward held: say it again.</source>
        <translation>आगे: अगली वस्तु। आगे दबाए रखें: फिर से सुनें।</translation>
    </message>
    <message>
        <source>One moment please.</source>
        <translation>एक क्षण रुकिए।</translation>
    </message>
    <message>
        <source>Hold the grip lightly. The forces come on softly.</source>
        <translation>हैंडल हल्के से पकड़ें। बल धीरे-धीरे आएँगे।</translation>
    </message>
    <message>
        <source>Middle: where am I. Plus: closer. Minus: wider. Forward: move.</source>
        <translation>बीच: मैं कहाँ हूँ। प्लस: पास। माइनस: चौड़ा। आगे: खिसकाएँ।</translation>
    </message>
    <message>
        <source>Minus held: the whole relief, then other objects.</source>
        <translation>माइनस दबाए रखें: पूरा उभार, फिर दूसरी वस्तुएँ।</translation>
    </message>
    <message>
        <source>Are you still there? Press any button, or I will stop.</source>
        <translation>क्या आप अभी यहाँ हैं? कोई बटन दबाएँ, नहीं तो मैं रुक जाऊँगा।</translation>
    </message>
    <message>
        <source>Goodbye.</source>
        <translation>नमस्ते, फिर मिलेंगे।</translation>
    </message>
    <message>
        <source>This object cannot be touched now.</source>
        <translation>यह वस्तु अभी नहीं छुई जा सकती।</translation>
    </message>
    <message>
        <source>This exhibit needs help. Please ask the staff.</source>
        <translation>इस प्रदर्शनी को सहायता चाहिए। कृपया कर्मचारियों से कहें।</translation>
    </message>
    <message>
        <source>Staff: type the PIN, then Enter. Escape goes back.</source>
        <translation>कर्मचारी: PIN टाइप करें, फिर Enter। Escape से वापस।</translation>
    </message>
    <message>
        <source>That is not the PIN. {1|%1 try is|%1 tries are} left.</source>
        <translation>यह PIN नहीं है। {1|%1 प्रयास बचा है|%1 प्रयास बचे हैं}।</translation>
    </message>
    <message>
        <source>Too many tries. A PIN is taken again in %1 s.</source>
        <translation>बहुत अधिक प्रयास। %1 s बाद फिर PIN ली जाएगी।</translation>
    </message>
    <message>
        <source>A map of %1 x %2 samples cannot be exported.</source>
        <translation>%1 x %2 नमूनों का नक्शा निर्यात नहीं हो सकता।</translation>
    </message>
    <message>
        <source>The map has no height anywhere, so there is nothing to export.</source>
        <translation>नक्शे में कहीं कोई ऊँचाई नहीं है, इसलिए निर्यात करने को कुछ नहीं है।</translation>
    </message>
    <message>
        <source>A plate to print needs a thickness above 0.</source>
        <translation>छापने की प्लेट को 0 से अधिक मोटाई चाहिए।</translation>
    </message>
    <message>
        <source>The map has more triangles than an STL file can count. Use fewer cells.</source>
        <translation>नक्शे में उससे अधिक त्रिभुज हैं जितने STL फ़ाइल गिन सकती है। कम कोष्ठ लें।</translation>
    </message>
    <message>
        <source>No four neighbouring cells have a height, so there is no surface to export as glTF. Nothing was written. Choose points (.xyz).</source>
        <translation>किन्हीं चार पड़ोसी कोष्ठों में ऊँचाई नहीं है, इसलिए glTF के रूप में निर्यात करने को कोई सतह नहीं है। कुछ नहीं लिखा गया। बिंदु (.xyz) चुनें।</translation>
    </message>
    <message>
        <source>The mesh has more than the 4 GB that a glTF file can hold. Nothing was written. Export a coarser level or a window.</source>
        <translation>जाली उन 4 GB से बड़ी है जितना glTF फ़ाइल में समाता है। कुछ नहीं लिखा गया। कोई मोटा स्तर या एक विंडो निर्यात करें।</translation>
    </message>
    <message>
        <source>Another program cannot be started: no more than %1 files may be open at once here (ulimit -n), and it takes %2. Allow more and try again.</source>
        <translation>दूसरा प्रोग्राम शुरू नहीं हो सकता: यहाँ एक साथ %1 से अधिक फ़ाइलें खुली नहीं हो सकतीं (ulimit -n), और उसे %2 चाहिए। अधिक की अनुमति दें और फिर कोशिश करें।</translation>
    </message>
    <message>
        <source>Another program cannot be started: %1. Close other programs and try again.</source>
        <translation>दूसरा प्रोग्राम शुरू नहीं हो सकता: %1। दूसरे प्रोग्राम बंद करें और फिर कोशिश करें।</translation>
    </message>
    <message>
        <source>Another program cannot be started: %1. Install relievo again, or give the right to run it.</source>
        <translation>दूसरा प्रोग्राम शुरू नहीं हो सकता: %1। relievo फिर से स्थापित करें, या उसे चलाने का अधिकार दें।</translation>
    </message>
    <message>
        <source>Cannot write %1: a file of this name is there that relievo did not write. It was left as it is. Move it, or choose another name for the result.</source>
        <translation>%1 लिखी नहीं जा सकती: इस नाम की एक फ़ाइल है जो relievo ने नहीं लिखी। वह जैसी थी वैसी रही। उसे हटाएँ, या परिणाम के लिए दूसरा नाम चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it is not a readable TIFF. Copy or export it again.</source>
        <translation>%1 पढ़ी नहीं जा सकती: यह पढ़ने योग्य TIFF नहीं है। इसे फिर से कॉपी या निर्यात करें।</translation>
    </message>
    <message>
        <source>Cannot read %1: its heights take %2 MB, and there is less room where they are kept meanwhile. Free some space, or write the result to another disk.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसकी ऊँचाइयाँ %2 MB लेती हैं, और जहाँ वे इस बीच रखी जाती हैं वहाँ जगह कम है। जगह खाली करें, या परिणाम दूसरी डिस्क पर लिखें।</translation>
    </message>
    <message>
        <source>The import cannot keep heights in %1: %2. Write the result to another folder.</source>
        <translation>आयात %1 में ऊँचाइयाँ नहीं रख सकता: %2। परिणाम दूसरे फ़ोल्डर में लिखें।</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds more than %2 points, the limit. Thin it out or cut it into parts first.</source>
        <translation>%1 पढ़ी नहीं जा सकती: इसमें %2 से अधिक बिंदु हैं, जो सीमा है। पहले इसे विरल करें या भागों में बाँटें।</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true या false</translation>
    </message>
    <message>
        <source>Plus held: help, and louder, softer, say it again.</source>
        <translation>प्लस दबाए रखें: सहायता, तेज़, धीमा, फिर से।</translation>
    </message>
    <message>
        <source>Hold the grip lightly. Nothing will pull you.</source>
        <translation>हैंडल हल्के से पकड़ें। कुछ भी आपको नहीं खींचेगा।</translation>
    </message>
    <message>
        <source>Push it in as far as it goes, and pull it out.</source>
        <translation>उसे पूरा अंदर धकेलें, फिर बाहर खींचें।</translation>
    </message>
    <message>
        <source>Now the buttons. Press any of them to go on.</source>
        <translation>अब बटन। आगे बढ़ने के लिए कोई बटन दबाएँ।</translation>
    </message>
    <message>
        <source>Middle button: where am I.</source>
        <translation>बीच का बटन: मैं कहाँ हूँ।</translation>
    </message>
    <message>
        <source>Plus: closer. Plus held: help.</source>
        <translation>प्लस: पास। प्लस दबाए रखें: सहायता।</translation>
    </message>
    <message>
        <source>Minus: wider. Minus held: the whole relief.</source>
        <translation>माइनस: चौड़ा। माइनस दबाए रखें: पूरा उभार।</translation>
    </message>
    <message>
        <source>Forward: move. Forward held: a marker.</source>
        <translation>आगे: खिसकाएँ। आगे दबाए रखें: एक निशान।</translation>
    </message>
    <message>
        <source>Middle button held long: stop, and go on.</source>
        <translation>बीच का बटन देर तक दबाए रखें: रुकें, फिर चलें।</translation>
    </message>
    <message>
        <source>You feel all of it now.</source>
        <translation>अभी आप उसे पूरा छू रहे हैं।</translation>
    </message>
    <message>
        <source>Shall I guide your hand along the outline once?</source>
        <translation>क्या मैं आपका हाथ एक बार रूपरेखा पर ले चलूँ?</translation>
    </message>
    <message>
        <source>Plus for yes, Minus for no.</source>
        <translation>हाँ के लिए प्लस, नहीं के लिए माइनस।</translation>
    </message>
    <message>
        <source>Now touch as you like.</source>
        <translation>अब जैसे चाहें वैसे छुएँ।</translation>
    </message>
    <message>
        <source>Not measured here. The real surface is missing in the scan.</source>
        <translation>यहाँ मापा नहीं गया। असली सतह स्कैन में नहीं है।</translation>
    </message>
    <message>
        <source>Forces off. Middle button held long: on again.</source>
        <translation>बल बंद। बीच का बटन देर तक दबाए रखें: फिर चालू।</translation>
    </message>
    <message>
        <source>Take the grip again to go on.</source>
        <translation>आगे बढ़ने के लिए हैंडल फिर पकड़ें।</translation>
    </message>
    <message>
        <source>Now Plus is louder and Minus is softer.</source>
        <translation>अब प्लस से तेज़ और माइनस से धीमा।</translation>
    </message>
    <message>
        <source>Middle button: say it again. Forward: back to touching.</source>
        <translation>बीच का बटन: फिर से कहें। आगे: वापस छूने पर।</translation>
    </message>
    <message>
        <source>Take it</source>
        <translation>इसे लें</translation>
    </message>
    <message>
        <source>The next one</source>
        <translation>अगला</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>वापस</translation>
    </message>
    <message>
        <source>One button. Press: I offer where am I, finer, coarser, whole object, move, guide, forces, say it again, louder, softer, help. Press again to take what I said last. Hold for a second and a half: forces off.</source>
        <translation>एक बटन। दबाएँ: मैं बारी-बारी से बताता हूँ: मैं कहाँ हूँ, बारीक, मोटा, पूरी वस्तु, खिसकाना, ले चलना, बल, फिर से कहें, और तेज़, और धीमा, सहायता। जो अंत में कहा गया उसे लेने के लिए फिर दबाएँ। डेढ़ सेकंड दबाए रखें: बल बंद।</translation>
    </message>
    <message>
        <source>The plug-in %1 was not allowed, so that nothing was taken back.</source>
        <translation>प्लगइन %1 को अनुमति नहीं थी; कुछ वापस नहीं लिया गया।</translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;. Nothing was changed. Name the maker&apos;s library itself, libdhd.so.3 for example.</source>
        <translation>फ़ाइल &quot;%1&quot; नहीं है। कुछ नहीं बदला। निर्माता की लाइब्रेरी का ही नाम दें, जैसे libdhd.so.3।</translation>
    </message>
    <message>
        <source>The settings of devices could not be written to &quot;%1&quot;. Nothing was changed. Check the folder&apos;s permissions.</source>
        <translation>उपकरणों की सेटिंग &quot;%1&quot; में लिखी नहीं जा सकीं। कुछ नहीं बदला। फ़ोल्डर की अनुमति जाँचें।</translation>
    </message>
    <message>
        <source>A Haply device was plugged in.</source>
        <translation>एक Haply उपकरण जोड़ा गया।</translation>
    </message>
    <message>
        <source>A Haply device was unplugged.</source>
        <translation>एक Haply उपकरण निकाला गया।</translation>
    </message>
    <message>
        <source>The Haply device connects and goes away again and again. Look at its cable, its plug and its power supply.</source>
        <translation>Haply उपकरण बार-बार जुड़ता और चला जाता है। उसकी केबल, प्लग और बिजली-अडैप्टर देखें।</translation>
    </message>
    <message>
        <source>The Haply device connects again and again. Look at its cable.</source>
        <translation>Haply उपकरण बार-बार जुड़ता है। उसकी केबल देखें।</translation>
    </message>
    <message>
        <source>The battery of the Haply grip is low. Charge it.</source>
        <translation>Haply मूठ की बैटरी कम है। उसे चार्ज करें।</translation>
    </message>
    <message>
        <source>The battery of the grip is low.</source>
        <translation>मूठ की बैटरी कम है।</translation>
    </message>
    <message>
        <source>The Haply grip went to sleep. Press one of its buttons to wake it.</source>
        <translation>Haply मूठ सो गई। उसे जगाने के लिए उसका कोई बटन दबाएँ।</translation>
    </message>
    <message>
        <source>The grip went to sleep.</source>
        <translation>मूठ सो गई।</translation>
    </message>
    <message>
        <source>The calibration of the Haply device failed. Put its grip into the inkwell again and wait until the light is steady.</source>
        <translation>Haply उपकरण का अंशांकन विफल हुआ। उसकी मूठ को फिर आधार-खाँचे में रखें और बत्ती के स्थिर होने तक रुकें।</translation>
    </message>
    <message>
        <source>The calibration failed. Put the grip into the inkwell again.</source>
        <translation>अंशांकन विफल हुआ। मूठ को फिर आधार-खाँचे में रखें।</translation>
    </message>
    <message>
        <source>The emergency stop of the Haply device was pressed. Forces are off until it is released.</source>
        <translation>Haply उपकरण की आपात-रोक दबाई गई। उसके छूटने तक बल बंद हैं।</translation>
    </message>
    <message>
        <source>The emergency stop was pressed.</source>
        <translation>आपात-रोक दबाई गई।</translation>
    </message>
    <message>
        <source>The emergency stop of the Haply device was released. F5 switches forces on again.</source>
        <translation>Haply उपकरण की आपात-रोक छूट गई। F5 से बल फिर चालू होते हैं।</translation>
    </message>
    <message>
        <source>The emergency stop was released.</source>
        <translation>आपात-रोक छूट गई।</translation>
    </message>
    <message>
        <source>A motor of the Haply device is held fast. Let its arm move freely.</source>
        <translation>Haply उपकरण की एक मोटर रुकी हुई है। उसकी बाँह को खुला चलने दें।</translation>
    </message>
    <message>
        <source>A motor is held fast.</source>
        <translation>एक मोटर रुकी हुई है।</translation>
    </message>
    <message>
        <source>The Haply service holds the forces down, because the arm trembles. Hold the grip more firmly, or lower the strength.</source>
        <translation>Haply की सेवा बल को कम रखती है, क्योंकि बाँह काँपती है। मूठ को मज़बूती से पकड़ें, या प्रबलता घटाएँ।</translation>
    </message>
    <message>
        <source>Forces are held down, because the arm trembles.</source>
        <translation>बल कम रखे जाते हैं, क्योंकि बाँह काँपती है।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds values outside 0 to 1, such as %2, and was not used. Scale them: 1 where the surface is stiff, 0 where it is softest.</source>
        <translation>&apos;%1&apos; में 0 से 1 के बाहर के मान हैं, जैसे %2, और यह काम में नहीं लिया गया। उन्हें मापें: 1 जहाँ सतह कठोर है, 0 जहाँ वह सबसे नरम है।</translation>
    </message>
    <message>
        <source>Maps by tiles are made by the method CPU. Nothing was made.</source>
        <translation>टाइलों वाले मानचित्र CPU विधि से बनते हैं। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>Heights other than front are for point clouds by the method CPU. Nothing was made.</source>
        <translation>front के अलावा प्रति सेल दूसरी ऊँचाइयाँ CPU विधि में बिंदु-समूहों के लिए हैं। कुछ नहीं बना।</translation>
    </message>
    <message>
        <source>The vertical exaggeration must be a finite number above 0; 1 is true to scale.</source>
        <translation>ऊर्ध्व अतिरंजन 0 से बड़ी परिमित संख्या होना चाहिए; 1 असली पैमाना है।</translation>
    </message>
    <message>
        <source>The pyramid factor must be from 1.1 to 8. Nothing was made; 2 is the paper&apos;s.</source>
        <translation>पिरामिड गुणक 1.1 से 8 तक होना चाहिए। कुछ नहीं बना; लेख का मान 2 है।</translation>
    </message>
    <message>
        <source>The pyramid factor is so near to 1 that its levels do not fit into memory. Nothing was made; choose a larger one.</source>
        <translation>पिरामिड गुणक 1 के इतना पास है कि उसके स्तर मेमोरी में नहीं समाते। कुछ नहीं बना; बड़ा गुणक चुनें।</translation>
    </message>
    <message>
        <source>The recording does not say where its stiffness map is. Nothing was replayed.</source>
        <translation>रिकॉर्डिंग नहीं बताती कि उसका कठोरता मानचित्र कहाँ है। कुछ नहीं दोहराया गया।</translation>
    </message>
    <message>
        <source>--relief: shaded relief has no values. Choose another, or &apos;relievo render&apos;.</source>
        <translation>--relief: छायांकित उभार के मान नहीं होते। दूसरा चुनें, या &apos;relievo render&apos;।</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the stiffness map that was felt (checksum differs, E501). Nothing was replayed. Put the right one back, there or beside the recording.</source>
        <translation>&apos;%1&apos; वह कठोरता मानचित्र नहीं है जिसे छुआ गया (चेकसम अलग, E501)। कुछ नहीं दोहराया गया। सही मानचित्र वहाँ या रिकॉर्डिंग के पास रखें।</translation>
    </message>
    <message>
        <source>Exaggeration, grip factor and number of windows must be above 0. Nothing was made.</source>
        <translation>ऊर्ध्व अतिरंजन, पकड़-गुणक और खिड़कियों की संख्या 0 से ऊपर होनी चाहिए। कुछ नहीं बनाया गया।</translation>
    </message>
    <message>
        <source>Bookmark: %1.</source>
        <translation>बुकमार्क: %1।</translation>
    </message>
    <message>
        <source>Resolution %1 of %2, window %3.</source>
        <translation>रिज़ॉल्यूशन %2 में से %1, विंडो %3।</translation>
    </message>
    <message>
        <source>Resolution %1 of %2, %4 wide.</source>
        <translation>रिज़ॉल्यूशन %2 में से %1, चौड़ाई %4।</translation>
    </message>
    <message>
        <source>Finer resolution</source>
        <translation>बारीक रिज़ॉल्यूशन</translation>
    </message>
    <message>
        <source>Coarser resolution</source>
        <translation>मोटा रिज़ॉल्यूशन</translation>
    </message>
    <message>
        <source>Resolution and scale</source>
        <translation>रिज़ॉल्यूशन और पैमाना</translation>
    </message>
    <message>
        <source>Next bookmark</source>
        <translation>अगला बुकमार्क</translation>
    </message>
    <message>
        <source>Previous bookmark</source>
        <translation>पिछला बुकमार्क</translation>
    </message>
    <message>
        <source>Plus: finer; long: resolution and scale. Minus: coarser; long: whole object. Forward: move; long: marker. Centre: where am I; long: forces off or on. Plus and Minus: look or touch; for two seconds: help; for five: introduction.</source>
        <translation>प्लस: बारीक; देर तक: रिज़ॉल्यूशन और पैमाना। माइनस: मोटा; देर तक: पूरी वस्तु। आगे: खिसकाना; देर तक: चिह्न। बीच: मैं कहाँ हूँ; देर तक: बल बंद या चालू। प्लस और माइनस: देखना या स्पर्श; दो सेकंड: सहायता; पाँच: परिचय।</translation>
    </message>
    <message>
        <source>Move mode. Push the grip to a side to go there. Plus: next bookmark. Minus: previous bookmark. Forward: done; long: guide along the outline. Centre: back; long: forces off or on. Plus and Minus for two seconds: help; for five: introduction.</source>
        <translation>खिसकाने की विधा। उधर जाने के लिए ग्रिप को एक ओर धकेलें। प्लस: अगला बुकमार्क। माइनस: पिछला बुकमार्क। आगे: पूरा; देर तक: रूपरेखा के साथ ले चलना। बीच: वापस; देर तक: बल बंद या चालू। प्लस और माइनस दो सेकंड: सहायता; पाँच: परिचय।</translation>
    </message>
    <message>
        <source>Move mode. Push the grip to a side to go there. Press: I offer done, next bookmark, previous bookmark, back, forces, say it again, louder, softer, help. Press again to take it. Hold for a second and a half: forces off.</source>
        <translation>खिसकाने की विधा। उधर जाने के लिए ग्रिप को एक ओर धकेलें। दबाएँ: मैं बारी-बारी से बताता हूँ: पूरा, अगला बुकमार्क, पिछला बुकमार्क, वापस, बल, फिर से कहें, और तेज़, और धीमा, सहायता। उसे लेने के लिए फिर दबाएँ। डेढ़ सेकंड दबाए रखें: बल बंद।</translation>
    </message>
    <message>
        <source>A stiffness map must hold 200 x 200 numbers from 0 to 1.</source>
        <translation>कठोरता मानचित्र में 0 से 1 तक की 200 x 200 संख्याएँ होनी चाहिए।</translation>
    </message>
    <message>
        <source>The pyramid factor must be from 1.1 to 8.</source>
        <translation>पिरामिड गुणक 1.1 से 8 तक होना चाहिए।</translation>
    </message>
    <message>
        <source>Resolution %2 is on its way. Until it is here, resolution %1 is shown and felt.</source>
        <translation>रिज़ॉल्यूशन %2 आ रहा है। उसके आने तक रिज़ॉल्यूशन %1 दिखाया और महसूस किया जाता है।</translation>
    </message>
    <message>
        <source>Resolution %1 is here.</source>
        <translation>रिज़ॉल्यूशन %1 आ गया है।</translation>
    </message>
    <message>
        <source>Full resolution.</source>
        <translation>पूरा रिज़ॉल्यूशन।</translation>
    </message>
    <message>
        <source>The graphics driver does not say how exact its depth buffer is. Use the method CPU instead.</source>
        <translation>ग्राफ़िक्स ड्राइवर नहीं बताता कि उसका गहराई बफ़र कितना सटीक है। इसके बदले CPU विधि काम में लें।</translation>
    </message>
    <message>
        <source>The graphics driver returned an empty depth buffer. Use the method CPU instead.</source>
        <translation>ग्राफ़िक्स ड्राइवर ने खाली गहराई बफ़र लौटाया। इसके बदले CPU विधि काम में लें।</translation>
    </message>
    <message>
        <source>Grid: %1 samples across (%2).</source>
        <translation>जाली: आर-पार %1 नमूने (%2)।</translation>
    </message>
    <message>
        <source>mesh: the paper&apos;s grid of 800 samples</source>
        <translation>जाल: लेख की 800 नमूनों वाली जाली</translation>
    </message>
    <message>
        <source>all points lie on one spot</source>
        <translation>सभी बिंदु एक ही जगह पर हैं</translation>
    </message>
    <message>
        <source>the points lie on a regular grid</source>
        <translation>बिंदु एक नियमित जाली पर हैं</translation>
    </message>
    <message>
        <source>%1 points a cell</source>
        <translation>प्रति कोशिका %1 बिंदु</translation>
    </message>
    <message>
        <source>Seen from here the points lie on one line of cells, so that next to nothing can be seen or touched. Choose another view, or more cells.</source>
        <translation>यहाँ से देखने पर बिंदु कोशिकाओं की एक ही पंक्ति पर हैं, इसलिए लगभग कुछ भी देखा या छुआ नहीं जा सकता। कोई दूसरा दृश्य या अधिक कोशिकाएँ चुनें।</translation>
    </message>
    <message>
        <source>Heights: %1.</source>
        <translation>ऊँचाइयाँ: %1।</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>as chosen</source>
        <translation>जैसा चुना गया</translation>
    </message>
    <message>
        <source>depth buffer</source>
        <translation>गहराई बफ़र</translation>
    </message>
    <message>
        <source>one point at each sample</source>
        <translation>हर नमूने पर एक बिंदु</translation>
    </message>
    <message>
        <source>%1 points per cell</source>
        <translation>प्रति कोशिका %1 बिंदु</translation>
    </message>
    <message>
        <source>%1 points per cell in several layers</source>
        <translation>कई परतों में प्रति कोशिका %1 बिंदु</translation>
    </message>
    <message>
        <source>%1 points per cell in one layer</source>
        <translation>एक परत में प्रति कोशिका %1 बिंदु</translation>
    </message>
    <message>
        <source>front-most point</source>
        <translation>सबसे आगे का बिंदु</translation>
    </message>
    <message>
        <source>second point from the front</source>
        <translation>आगे से दूसरा बिंदु</translation>
    </message>
    <message>
        <source>mean of the top layer</source>
        <translation>ऊपरी परत का औसत</translation>
    </message>
    <message>
        <source>median of the points</source>
        <translation>बिंदुओं का माध्यक</translation>
    </message>
    <message>
        <source>mean of the points</source>
        <translation>बिंदुओं का औसत</translation>
    </message>
    <message>
        <source>bilinear splat</source>
        <translation>द्विरैखिक वितरण</translation>
    </message>
    <message>
        <source>local quadratic</source>
        <translation>स्थानीय द्विघात सतह</translation>
    </message>
    <message>
        <source>rear-most point</source>
        <translation>सबसे पीछे का बिंदु</translation>
    </message>
    <message>
        <source>Depth buffer of %1 bits over %2: steps of %3, heights exact to %4.</source>
        <translation>%2 पर %1 बिट का गहराई बफ़र: %3 के चरण, ऊँचाइयाँ %4 तक सटीक।</translation>
    </message>
    <message>
        <source>Depth buffer of %1 bits, floating point, over %2: steps of %3, heights exact to %4.</source>
        <translation>%2 पर %1 बिट का, चल दशमलव वाला गहराई बफ़र: %3 के चरण, ऊँचाइयाँ %4 तक सटीक।</translation>
    </message>
    <message>
        <source>The object is as thick one way as the other; its best-fit plane is not certain.</source>
        <translation>वस्तु एक दिशा में उतनी ही मोटी है जितनी दूसरी में; उसका सबसे उपयुक्त तल निश्चित नहीं है।</translation>
    </message>
    <message>
        <source>The object is as long one way as the other; its principal axes are not certain.</source>
        <translation>वस्तु एक दिशा में उतनी ही लंबी है जितनी दूसरी में; उसके मुख्य अक्ष निश्चित नहीं हैं।</translation>
    </message>
    <message>
        <source>%1 of %2 holes filled. The largest left (%3 mm2) is larger than the limit of %4 mm2 and now rests on the base plane.</source>
        <translation>%2 में से %1 छेद भरे गए। बचा हुआ सबसे बड़ा (%3 mm2) %4 mm2 की सीमा से बड़ा है और अब आधार तल पर है।</translation>
    </message>
    <message>
        <source>%1 of %2 holes filled. The largest left (%3 mm2) is too large for a membrane or has too little rim and now rests on the base plane.</source>
        <translation>%2 में से %1 छेद भरे गए। बचा हुआ सबसे बड़ा (%3 mm2) झिल्ली के लिए बहुत बड़ा है या उसका किनारा बहुत कम है, और अब आधार तल पर है।</translation>
    </message>
    <message>
        <source>Seen from here %1 of the scan is hidden and cannot be felt. Turn the object, or continue.</source>
        <translation>यहाँ से देखने पर स्कैन का %1 छिपा है और छुआ नहीं जा सकता। वस्तु को घुमाएँ, या आगे बढ़ें।</translation>
    </message>
    <message>
        <source>%1 points far off all their neighbours were left out.</source>
        <translation>अपने सभी पड़ोसियों से बहुत दूर {1|का %1 बिंदु छोड़ा गया|के %1 बिंदु छोड़े गए}।</translation>
    </message>
    <message>
        <source>%1 cells showed the object&apos;s back through gaps of its front; they were interpolated instead.</source>
        <translation>{1|%1 कोशिका ने|%1 कोशिकाओं ने} वस्तु के सामने की दरारों से उसका पिछला भाग दिखाया; इसकी जगह {1|वह अंतर्वेशित की गई|वे अंतर्वेशित की गईं}।</translation>
    </message>
    <message>
        <source>Most cells are interpolated: %1 of the map is measured. A coarser grid would rest on more.</source>
        <translation>अधिकतर कोशिकाएँ अंतर्वेशित हैं: मानचित्र का %1 मापा हुआ है। मोटी जाली अधिक मापों पर टिकी होगी।</translation>
    </message>
    <message>
        <source>In %1 of the cells the points lie in several layers, front and back, and the chosen height per cell makes one height of them. Choose the mean of the top layer (topmean) to keep them apart.</source>
        <translation>%1 कोशिकाओं में बिंदु कई परतों में हैं, आगे और पीछे, और प्रति कोशिका चुनी गई ऊँचाई उनसे एक ऊँचाई बनाती है। उन्हें अलग रखने के लिए ऊपरी परत का औसत (topmean) चुनें।</translation>
    </message>
    <message>
        <source>%1 of %2 points {1|lies|lie} %3 of the box away from all others; {1|it was|they were} left out.</source>
        <translation>%2 में से %1 {1|बिंदु बाकी सबसे बॉक्स के %3 दूर है; उसे|बिंदु बाकी सबसे बॉक्स के %3 दूर हैं; उन्हें} छोड़ दिया गया।</translation>
    </message>
    <message>
        <source>%1 of %2 points {1|lies|lie} %3 of the box away from all others; {1|it was|they were} kept.</source>
        <translation>%2 में से %1 {1|बिंदु बाकी सबसे बॉक्स के %3 दूर है; उसे|बिंदु बाकी सबसे बॉक्स के %3 दूर हैं; उन्हें} रखा गया।</translation>
    </message>
    <message>
        <source>{1|%1 vertex belongs|%1 vertices belong} to no face and {1|lies|lie} outside of the object; {1|it was|they were} left out.</source>
        <translation>{1|%1 शीर्ष किसी फलक का नहीं है और वस्तु के बाहर है; उसे|%1 शीर्ष किसी फलक के नहीं हैं और वस्तु के बाहर हैं; उन्हें} छोड़ दिया गया।</translation>
    </message>
    <message>
        <source>%1 of %2 points lie together %3 of the box away from all others; they were left out.</source>
        <translation>%2 में से %1 बिंदु एक साथ बाकी सबसे बॉक्स के %3 दूर हैं; उन्हें छोड़ दिया गया।</translation>
    </message>
    <message>
        <source>%1 of %2 points lie together %3 of the box away from all others; they were kept, as they may belong to the object.</source>
        <translation>%2 में से %1 बिंदु एक साथ बाकी सबसे बॉक्स के %3 दूर हैं; उन्हें रखा गया, क्योंकि वे वस्तु के हो सकते हैं।</translation>
    </message>
    <message>
        <source>%1 of %2 heights are %3, which often stands for a missing one; they were left out. Say --nodata none to take them as heights, --nodata %3 to leave them out without this message.</source>
        <translation>%2 में से %1 ऊँचाइयाँ %3 हैं, जो अक्सर लापता ऊँचाई के लिए लिखा जाता है; उन्हें छोड़ दिया गया। उन्हें ऊँचाइयाँ मानने के लिए --nodata none दें, इस संदेश के बिना छोड़ने के लिए --nodata %3 दें।</translation>
    </message>
    <message>
        <source>%1 {1|height of|heights of} %2 {1|was|were} taken as missing.</source>
        <translation>%2 की %1 {1|ऊँचाई लापता मानी गई|ऊँचाइयाँ लापता मानी गईं}।</translation>
    </message>
    <message>
        <source>The points carry no unit; one file unit was taken as 1 %1, a guess: %2. Give the unit if it is another, for example feet.</source>
        <translation>बिंदुओं की कोई इकाई नहीं है; फ़ाइल की एक इकाई 1 %1 मानी गई, एक अनुमान: %2। इकाई कोई और हो, जैसे फ़ुट, तो उसे बताएँ।</translation>
    </message>
    <message>
        <source>The points carry no unit; one file unit was taken as 1 mm. Give the unit if it is another.</source>
        <translation>बिंदुओं की कोई इकाई नहीं है; फ़ाइल की एक इकाई 1 mm मानी गई। इकाई कोई और हो तो उसे बताएँ।</translation>
    </message>
    <message>
        <source>The points carry no unit; one file unit was taken as 1 mm. Give the unit if it is another. More likely is %1, %2 x %3 x %4 mm: %5.</source>
        <translation>बिंदुओं की कोई इकाई नहीं है; फ़ाइल की एक इकाई 1 mm मानी गई। इकाई कोई और हो तो उसे बताएँ। अधिक संभावना %1 की है, %2 x %3 x %4 mm: %5।</translation>
    </message>
    <message>
        <source>its coordinates are those of a map projection</source>
        <translation>इसके निर्देशांक किसी मानचित्र प्रक्षेप के हैं</translation>
    </message>
    <message>
        <source>it lies as far off as in a map projection</source>
        <translation>यह उतनी दूर है जितना किसी मानचित्र प्रक्षेप में होता है</translation>
    </message>
    <message>
        <source>files of this format are in metres as a rule</source>
        <translation>इस प्रारूप की फ़ाइलें आम तौर पर मीटर में होती हैं</translation>
    </message>
    <message>
        <source>it is smaller than anything scanned in millimetres</source>
        <translation>यह मिलीमीटर में स्कैन की गई किसी भी चीज़ से छोटा है</translation>
    </message>
    <message>
        <source>an object of this shape is seldom as small</source>
        <translation>इस आकार की वस्तु शायद ही इतनी छोटी होती है</translation>
    </message>
    <message>
        <source>it is larger than most that is in millimetres</source>
        <translation>यह मिलीमीटर में दी गई अधिकतर चीज़ों से बड़ा है</translation>
    </message>
    <message>
        <source>of its size</source>
        <translation>इसके आकार के कारण</translation>
    </message>
    <message>
        <source>The raster does not say how large it is; its samples were taken to lie %1 apart, and a step of its values to be %2 high. Say --pixel-size and --height-scale in mm; --height-zero is the value on the base plane.</source>
        <translation>रास्टर नहीं बताता कि वह कितना बड़ा है; उसके नमूनों की दूरी %1 मानी गई, और उसके मानों के एक चरण की ऊँचाई %2। --pixel-size और --height-scale mm में दें; --height-zero आधार तल पर मान है।</translation>
    </message>
    <message>
        <source>The raster does not say how large it is; its samples were taken to lie %1 apart, and a step of its values to be %2 high, a guess: with steps of a unit it would be higher than it is long, with these it is about a tenth as high. Say --pixel-size and --height-scale in mm; --height-zero is the value on the base plane.</source>
        <translation>रास्टर नहीं बताता कि वह कितना बड़ा है; उसके नमूनों की दूरी %1 मानी गई, और उसके मानों के एक चरण की ऊँचाई %2, एक अनुमान: एक इकाई के चरणों से वह लंबाई से अधिक ऊँचा होता, इनसे वह लगभग दसवें भाग जितना ऊँचा है। --pixel-size और --height-scale mm में दें; --height-zero आधार तल पर मान है।</translation>
    </message>
    <message>
        <source>The map has no origins of its own; every height was taken as measured.</source>
        <translation>मानचित्र में मूल की अपनी जानकारी नहीं है; हर ऊँचाई मापी हुई मानी गई।</translation>
    </message>
    <message>
        <source>A map written by this program is taken as it is; its holes were not treated anew.</source>
        <translation>इस प्रोग्राम का लिखा मानचित्र जैसा है वैसा ही लिया जाता है; उसके छेद फिर से नहीं भरे गए।</translation>
    </message>
    <message>
        <source>The map has colours beside it; the relief images &apos;natural&apos; and &apos;intensity&apos; show what there is.</source>
        <translation>मानचित्र के साथ रंग हैं; उभार-चित्र “प्राकृतिक रंग” और “तीव्रता” दिखाते हैं कि क्या है।</translation>
    </message>
    <message>
        <source>%1 The map is shown without colours.</source>
        <translation>%1 मानचित्र बिना रंगों के दिखाया गया है।</translation>
    </message>
    <message>
        <source>The scan has colours; %1 of the measured cells have one of their own. The relief image &apos;natural&apos; shows them.</source>
        <translation>स्कैन में रंग हैं; मापी गई कोशिकाओं में से %1 का अपना रंग है। उभार-चित्र “प्राकृतिक रंग” उन्हें दिखाता है।</translation>
    </message>
    <message>
        <source>The scan has intensities; %1 of the measured cells have one of their own. The relief image &apos;intensity&apos; shows them, black at %2 and white at %3.</source>
        <translation>स्कैन में तीव्रताएँ हैं; मापी गई कोशिकाओं में से %1 की अपनी तीव्रता है। उभार-चित्र “तीव्रता” उन्हें दिखाता है, %2 पर काला और %3 पर सफ़ेद।</translation>
    </message>
    <message>
        <source>A first view from %1 % of the points.</source>
        <translation>%1 % बिंदुओं से पहला दृश्य।</translation>
    </message>
    <message>
        <source>The points were merged as they came; stray points were not looked for.</source>
        <translation>बिंदु जैसे आए वैसे ही मिलाए गए; भटके बिंदु नहीं खोजे गए।</translation>
    </message>
    <message>
        <source>Went on with earlier work: %1 points were in tiles, %2 of %3 rows of tiles had their heights.</source>
        <translation>पहले का काम आगे बढ़ाया गया: %1 बिंदु टाइलों में थे, टाइलों की %3 में से %2 पंक्तियों की ऊँचाइयाँ बन चुकी थीं।</translation>
    </message>
    <message>
        <source>%1 of its files were damaged and were made anew.</source>
        <translation>उसकी {1|%1 फ़ाइल खराब थी और फिर से बनाई गई|%1 फ़ाइलें खराब थीं और फिर से बनाई गईं}।</translation>
    </message>
    <message>
        <source>The scan&apos;s colours were left out: with them this map needs about %1 MB of memory. Allow more with --memory.</source>
        <translation>स्कैन के रंग छोड़ दिए गए: उनके साथ इस मानचित्र को लगभग %1 MB मेमोरी चाहिए। --memory से अधिक की अनुमति दें।</translation>
    </message>
    <message>
        <source>Colours beside a map are not read by tiles; its levels are made without. Leave out --memory, or make the map from its scan.</source>
        <translation>मानचित्र के साथ के रंग टाइलों में नहीं पढ़े जाते; उसके स्तर उनके बिना बनते हैं। --memory हटाएँ, या मानचित्र उसके स्कैन से बनाएँ।</translation>
    </message>
    <message>
        <source>Points and spread per cell are known for point clouds by the method CPU only; no quality map was written.</source>
        <translation>प्रति कोशिका बिंदु और फैलाव केवल CPU विधि से बिंदु-बादलों के लिए ज्ञात हैं; कोई गुणवत्ता मानचित्र नहीं लिखा गया।</translation>
    </message>
    <message>
        <source>The file is incomplete: its header promises {1|%1 point|%1 points}, it ends at %2. What is there was loaded.</source>
        <translation>फ़ाइल अधूरी है: उसका शीर्ष %1 बिंदु बताता है, वह %2 पर समाप्त होती है। जो है वह लोड हुआ।</translation>
    </message>
    <message>
        <source>The file is incomplete: its header promises {1|%1 face|%1 faces}, it ends at %2. What is there was loaded.</source>
        <translation>फ़ाइल अधूरी है: उसका शीर्ष %1 फलक बताता है, वह %2 पर समाप्त होती है। जो है वह लोड हुआ।</translation>
    </message>
    <message>
        <source>The file is incomplete: its header promises %1 bytes, it ends at %2. What is there was loaded.</source>
        <translation>फ़ाइल अधूरी है: उसका शीर्ष %1 बाइट बताता है, वह %2 पर समाप्त होती है। जो है वह लोड हुआ।</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises {2|%2 face|%2 faces}, file ends at %3. Nothing was loaded. Choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: शीर्ष %2 फलक बताता है, फ़ाइल %3 पर समाप्त होती है। कुछ नहीं खोला गया। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises {2|%2 face|%2 faces}, file ends at %3. Nothing was loaded. Load the {4|%4 point|%4 points} and {3|%3 complete face|%3 complete faces}, or choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: शीर्ष %2 फलक बताता है, फ़ाइल %3 पर समाप्त होती है। कुछ नहीं खोला गया। %4 बिंदु और %3 पूरे फलक लोड करें, या दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises %2 bytes, file ends at %3. Nothing was loaded. Choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: शीर्ष %2 बाइट बताता है, फ़ाइल %3 पर समाप्त होती है। कुछ नहीं खोला गया। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises %2 bytes, file ends at %3. Nothing was loaded. Load the {4|%4 complete point|%4 complete points}, or choose another file.</source>
        <translation>%1 पढ़ी नहीं जा सकती: शीर्ष %2 बाइट बताता है, फ़ाइल %3 पर समाप्त होती है। कुछ नहीं खोला गया। %4 पूरे बिंदु लोड करें, या दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>{1|%1 face has|%1 faces have} dents and more than 4096 corners; {1|it was|they were} cut into triangles without regard to these. Split them where they were made.</source>
        <translation>%1 फलकों में अंदर मुड़े कोने और 4096 से अधिक कोने हैं; वे इनका ध्यान रखे बिना त्रिभुजों में काटे गए। जहाँ वे बने, वहीं उन्हें बाँटें।</translation>
    </message>
    <message>
        <source>%1 of %2 faces {1|was|were} left out: they name points that are not there or not finite, or have fewer than three corners.</source>
        <translation>%2 में से %1 फलक छोड़े गए: वे ऐसे बिंदु बताते हैं जो नहीं हैं या परिमित नहीं हैं, या उनके तीन से कम कोने हैं।</translation>
    </message>
    <message>
        <source>One point in %1 was taken: %2 of %3.</source>
        <translation>%1 में से एक बिंदु लिया गया: %3 में से %2।</translation>
    </message>
    <message>
        <source>{1|%1 point|%1 points} beyond 1e38 {1|was|were} left out; they are no measurements.</source>
        <translation>1e38 से परे के %1 बिंदु छोड़े गए; वे माप नहीं हैं।</translation>
    </message>
    <message>
        <source>The scan has one point only.</source>
        <translation>स्कैन में केवल एक बिंदु है।</translation>
    </message>
    <message>
        <source>All points are the same.</source>
        <translation>सभी बिंदु एक ही हैं।</translation>
    </message>
    <message>
        <source>Its colours hold numbers beyond 65535, which mean nothing known; they were left out.</source>
        <translation>उसके रंगों में 65535 से बड़ी संख्याएँ हैं, जिनका कोई ज्ञात अर्थ नहीं; वे छोड़ दिए गए।</translation>
    </message>
    <message>
        <source>Its colours hold nothing but 0 and 1; they were taken as none and all of red, green, blue.</source>
        <translation>उसके रंगों में केवल 0 और 1 हैं; वे लाल, हरे, नीले का शून्य और पूरा माने गए।</translation>
    </message>
    <message>
        <source>%1: its colours are not of the form of those before; no colours are taken.</source>
        <translation>%1: उसके रंग पहले वालों के रूप के नहीं हैं; कोई रंग नहीं लिए जाते।</translation>
    </message>
    <message>
        <source>And %1 more such {1|remark|remarks} on the files.</source>
        <translation>और फ़ाइलों पर ऐसी %1 और टिप्पणियाँ।</translation>
    </message>
    <message>
        <source>Commas were read as decimal points.</source>
        <translation>अल्पविराम दशमलव चिह्न के रूप में पढ़े गए।</translation>
    </message>
    <message>
        <source>Line %1 names no columns x, y, z; the first three columns were taken.</source>
        <translation>पंक्ति %1 स्तंभ x, y, z नहीं बताती; पहले तीन स्तंभ लिए गए।</translation>
    </message>
    <message>
        <source>The first line promises %1 points; the file holds %2, and all were loaded.</source>
        <translation>पहली पंक्ति %1 बिंदु बताती है; फ़ाइल में %2 हैं, और सब लोड हुए।</translation>
    </message>
    <message>
        <source>Header line %1 (&quot;%2&quot;) is not of PLY; it was passed over.</source>
        <translation>शीर्ष की पंक्ति %1 (“%2”) PLY की नहीं है; वह छोड़ दी गई।</translation>
    </message>
    <message>
        <source>Header line %1 (&quot;%2&quot;) is not of PCD; it was passed over.</source>
        <translation>शीर्ष की पंक्ति %1 (“%2”) PCD की नहीं है; वह छोड़ दी गई।</translation>
    </message>
    <message>
        <source>The file ends early, within &quot;%1&quot;; all points were loaded.</source>
        <translation>फ़ाइल समय से पहले, “%1” के बीच समाप्त होती है; सभी बिंदु लोड हुए।</translation>
    </message>
    <message>
        <source>Its &quot;%1&quot; records are of a kind that is not read; the points were loaded without faces.</source>
        <translation>उसके “%1” अभिलेख ऐसे प्रकार के हैं जो पढ़े नहीं जाते; बिंदु फलकों के बिना लोड हुए।</translation>
    </message>
    <message>
        <source>Its faces have colours, its points none; colours of faces are not read. Save it with colours of vertices.</source>
        <translation>उसके फलकों के रंग हैं, बिंदुओं के नहीं; फलकों के रंग पढ़े नहीं जाते। उसे बिंदुओं के रंगों के साथ सहेजें।</translation>
    </message>
    <message>
        <source>Bytes after the last triangle were ignored.</source>
        <translation>अंतिम त्रिभुज के बाद की बाइटों पर ध्यान नहीं दिया गया।</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, which it names, %2; the mesh was loaded without it.</source>
        <translation>फ़ाइल में बताई गई “%1” %2; जाल उसके बिना लोड हुआ।</translation>
    </message>
    <message>
        <source>lies outside its folder and was not opened</source>
        <translation>उसके फ़ोल्डर से बाहर है और खोली नहीं गई</translation>
    </message>
    <message>
        <source>is not there</source>
        <translation>वहाँ नहीं है</translation>
    </message>
    <message>
        <source>is no file, or too large</source>
        <translation>कोई फ़ाइल नहीं है, या बहुत बड़ी है</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>पढ़ी नहीं जा सकती</translation>
    </message>
    <message>
        <source>is one picture too many</source>
        <translation>एक चित्र अधिक है</translation>
    </message>
    <message>
        <source>carries more metadata than are taken</source>
        <translation>में उससे अधिक मेटाडेटा है जितना लिया जाता है</translation>
    </message>
    <message>
        <source>is no PNG, JPEG or TIFF picture</source>
        <translation>PNG, JPEG या TIFF चित्र नहीं है</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, more than are taken</source>
        <translation>में %1 x %2 पिक्सेल हैं, जितने लिए जाते हैं उनसे अधिक</translation>
    </message>
    <message>
        <source>is no picture of 8 or 16 bits</source>
        <translation>8 या 16 बिट का चित्र नहीं है</translation>
    </message>
    <message>
        <source>cannot be decoded (%1)</source>
        <translation>डिकोड नहीं की जा सकती (%1)</translation>
    </message>
    <message>
        <source>%1 of %2 scans {1|was|were} left out: %3.</source>
        <translation>%2 में से %1 स्कैन छोड़े गए: %3।</translation>
    </message>
    <message>
        <source>%1 of %2 scans {1|was|were} left out: %3 and others.</source>
        <translation>%2 में से %1 स्कैन छोड़े गए: %3 और अन्य।</translation>
    </message>
    <message>
        <source>scan %1 (%2)</source>
        <translation>स्कैन %1 (%2)</translation>
    </message>
    <message>
        <source>scan %1 &quot;%2&quot; (%3)</source>
        <translation>स्कैन %1 “%2” (%3)</translation>
    </message>
    <message>
        <source>%1 of its points {1|is|are} marked as withheld (not to be used) and {1|was|were} taken all the same.</source>
        <translation>उसके %1 बिंदु रोके गए (उपयोग के लिए नहीं) चिह्नित हैं और फिर भी लिए गए।</translation>
    </message>
    <message>
        <source>%1 of its points {1|is|are} marked as withheld (not to be used) and {1|was|were} left out. They can be taken, too (--keep-withheld).</source>
        <translation>उसके %1 बिंदु रोके गए (उपयोग के लिए नहीं) चिह्नित हैं और छोड़े गए। उन्हें भी लिया जा सकता है (--keep-withheld)।</translation>
    </message>
    <message>
        <source>Bytes after the last of the points that the header promises were ignored.</source>
        <translation>शीर्ष के बताए अंतिम बिंदु के बाद की बाइटों पर ध्यान नहीं दिया गया।</translation>
    </message>
    <message>
        <source>Its heights are in %1, its x and y in %2; heights were converted to %2.</source>
        <translation>उसकी ऊँचाइयाँ %1 में हैं, उसके x और y %2 में; ऊँचाइयाँ %2 में बदली गईं।</translation>
    </message>
    <message>
        <source>Its x and y are degrees, not lengths, so shapes will be wrong. Reproject it to metres, for example with pdal translate and filters.reprojection.</source>
        <translation>उसके x और y डिग्री हैं, लंबाई नहीं, इसलिए आकृतियाँ ग़लत होंगी। उसे मीटर में पुनः प्रक्षेपित करें, जैसे pdal translate और filters.reprojection से।</translation>
    </message>
    <message>
        <source>It states a unit %1, which is not known here; state it (--unit).</source>
        <translation>वह इकाई %1 बताती है, जो यहाँ ज्ञात नहीं; उसे बताएँ (--unit)।</translation>
    </message>
    <message>
        <source>It names its coordinate system, EPSG:%1, which is not known here, and no unit; state it (--unit).</source>
        <translation>वह अपनी निर्देशांक प्रणाली, EPSG:%1, बताती है, जो यहाँ ज्ञात नहीं, और कोई इकाई नहीं; उसे बताएँ (--unit)।</translation>
    </message>
    <message>
        <source>It names its coordinate system, EPSG:%1, whose x and y are degrees, not lengths, so shapes will be wrong. Reproject it to metres.</source>
        <translation>वह अपनी निर्देशांक प्रणाली, EPSG:%1, बताती है, जिसके x और y डिग्री हैं, लंबाई नहीं, इसलिए आकृतियाँ ग़लत होंगी। उसे मीटर में पुनः प्रक्षेपित करें।</translation>
    </message>
    <message>
        <source>It names its coordinate system, EPSG:%1, whose unit of %2 m is not known here; state it (--unit).</source>
        <translation>वह अपनी निर्देशांक प्रणाली, EPSG:%1, बताती है, जिसकी %2 m की इकाई यहाँ ज्ञात नहीं; उसे बताएँ (--unit)।</translation>
    </message>
    <message>
        <source>Points lie outside the box that the header states, so that the file may be damaged: LAZ holds no checksum.</source>
        <translation>बिंदु शीर्ष के बताए घनाभ से बाहर हैं, इसलिए फ़ाइल बिगड़ी हो सकती है: LAZ में जाँच-योग नहीं होता।</translation>
    </message>
    <message>
        <source>The points are not of the returns that the header counts, so that the file may be damaged: LAZ holds no checksum.</source>
        <translation>बिंदु उन प्रतिध्वनियों के नहीं हैं जिन्हें शीर्ष गिनता है, इसलिए फ़ाइल बिगड़ी हो सकती है: LAZ में जाँच-योग नहीं होता।</translation>
    </message>
    <message>
        <source>Blocks of points hold bytes behind their last point, so that the file may be damaged: LAZ holds no checksum.</source>
        <translation>बिंदुओं के खंडों में उनके अंतिम बिंदु के पीछे बाइटें हैं, इसलिए फ़ाइल बिगड़ी हो सकती है: LAZ में जाँच-योग नहीं होता।</translation>
    </message>
    <message>
        <source>The file ends before the list of its blocks of points, so that it was cut or not written to its end; the blocks were found without it.</source>
        <translation>फ़ाइल अपने बिंदु-खंडों की सूची से पहले समाप्त होती है, यानी काटी गई या अंत तक लिखी नहीं गई; खंड उसके बिना मिले।</translation>
    </message>
    <message>
        <source>The raster has no georeference; one pixel was taken as one unit.</source>
        <translation>रास्टर में भू-संदर्भ नहीं है; एक पिक्सेल एक इकाई माना गया।</translation>
    </message>
    <message>
        <source>The raster has %1 bands; the first was read as heights.</source>
        <translation>रास्टर में %1 बैंड हैं; पहला ऊँचाइयों के रूप में पढ़ा गया।</translation>
    </message>
    <message>
        <source>The raster&apos;s unit of %1 m is not known here; state it (--unit).</source>
        <translation>रास्टर की %1 m की इकाई यहाँ ज्ञात नहीं; उसे बताएँ (--unit)।</translation>
    </message>
    <message>
        <source>The raster states no unit for its heights; they were taken to be in the unit of its coordinates.</source>
        <translation>रास्टर अपनी ऊँचाइयों की इकाई नहीं बताता; वे उसके निर्देशांकों की इकाई में मानी गईं।</translation>
    </message>
    <message>
        <source>Heights in %1 were converted to %2, the unit of the coordinates.</source>
        <translation>%1 की ऊँचाइयाँ निर्देशांकों की इकाई %2 में बदली गईं।</translation>
    </message>
    <message>
        <source>The reference system of the heights was left out: it does not hold for another unit.</source>
        <translation>ऊँचाइयों की संदर्भ प्रणाली छोड़ दी गई: वह दूसरी इकाई पर लागू नहीं होती।</translation>
    </message>
    <message>
        <source>%1 was not written with the map and was left aside.</source>
        <translation>%1 मानचित्र के साथ नहीं लिखी गई और अलग छोड़ी गई।</translation>
    </message>
    <message>
        <source>%1 belongs to another map and was left aside.</source>
        <translation>%1 दूसरे मानचित्र की है और अलग छोड़ी गई।</translation>
    </message>
    <message>
        <source>%1 cannot be read and was left aside.</source>
        <translation>%1 पढ़ी नहीं जा सकती और अलग छोड़ी गई।</translation>
    </message>
    <message>
        <source>%1 has another size than the map and was left aside.</source>
        <translation>%1 का आकार मानचित्र से भिन्न है और वह अलग छोड़ी गई।</translation>
    </message>
    <message>
        <source>%1 does not fit the map and was left aside.</source>
        <translation>%1 मानचित्र से मेल नहीं खाती और अलग छोड़ी गई।</translation>
    </message>
    <message>
        <source>In %1: %2</source>
        <translation>%1 में: %2</translation>
    </message>
    <message>
        <source>Cannot read %1: %2</source>
        <translation>%1 पढ़ी नहीं जा सकती: %2</translation>
    </message>
    <message>
        <source>Export it again.</source>
        <translation>इसे फिर से निर्यात करें।</translation>
    </message>
    <message>
        <source>Copy or export it again.</source>
        <translation>इसे फिर से कॉपी या निर्यात करें।</translation>
    </message>
    <message>
        <source>The file is damaged; export it again.</source>
        <translation>फ़ाइल क्षतिग्रस्त है; इसे फिर से निर्यात करें।</translation>
    </message>
    <message>
        <source>The file is damaged; copy or export it again.</source>
        <translation>फ़ाइल क्षतिग्रस्त है; इसे फिर से कॉपी या निर्यात करें।</translation>
    </message>
    <message>
        <source>Convert it to LAS.</source>
        <translation>इसे LAS में बदलें।</translation>
    </message>
    <message>
        <source>Write the map again.</source>
        <translation>मानचित्र फिर से लिखें।</translation>
    </message>
    <message>
        <source>line %1 is longer than 64 kB. It is no file of points.</source>
        <translation>पंक्ति %1 की लंबाई 64 kB से अधिक है। यह बिंदुओं की फ़ाइल नहीं है।</translation>
    </message>
    <message>
        <source>line %1 (&quot;%2&quot;) does not start with three numbers. Correct the line, or choose another file.</source>
        <translation>पंक्ति %1 (“%2”) तीन संख्याओं से शुरू नहीं होती। पंक्ति ठीक करें, या दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>line %1 (&quot;%2&quot;) groups the digits of its numbers by thousands. Write them without such separators.</source>
        <translation>पंक्ति %1 (“%2”) में संख्याओं के अंक हज़ारों के समूहों में बँटे हैं। संख्याएँ ऐसे विभाजकों के बिना लिखें।</translation>
    </message>
    <message>
        <source>line %1 (&quot;%2&quot;) %3.</source>
        <translation>पंक्ति %1 (“%2”) %3।</translation>
    </message>
    <message>
        <source>header line %1 (&quot;%2&quot;) %3.</source>
        <translation>शीर्ष की पंक्ति %1 (“%2”) %3।</translation>
    </message>
    <message>
        <source>line %1 is longer than 1 MB.</source>
        <translation>पंक्ति %1 की लंबाई 1 MB से अधिक है।</translation>
    </message>
    <message>
        <source>does not hold three coordinates</source>
        <translation>में तीन निर्देशांक नहीं हैं</translation>
    </message>
    <message>
        <source>has too few numbers</source>
        <translation>में संख्याएँ बहुत कम हैं</translation>
    </message>
    <message>
        <source>has fewer numbers than the header says</source>
        <translation>में उससे कम संख्याएँ हैं जितनी शीर्ष बताता है</translation>
    </message>
    <message>
        <source>has a list without a usable length</source>
        <translation>में बिना मान्य लंबाई की सूची है</translation>
    </message>
    <message>
        <source>has a list shorter than it says</source>
        <translation>में एक सूची अपनी बताई लंबाई से छोटी है</translation>
    </message>
    <message>
        <source>names a corner that is no number</source>
        <translation>ऐसा कोना बताती है जो संख्या नहीं है</translation>
    </message>
    <message>
        <source>is no part of an STL file</source>
        <translation>STL फ़ाइल का भाग नहीं है</translation>
    </message>
    <message>
        <source>it does not start with the word &quot;ply&quot;. It is no PLY file, or damaged.</source>
        <translation>यह “ply” शब्द से शुरू नहीं होती। यह PLY फ़ाइल नहीं है, या क्षतिग्रस्त है।</translation>
    </message>
    <message>
        <source>its header mixes kinds of line ends.</source>
        <translation>शीर्ष में अलग-अलग प्रकार के पंक्ति-अंत मिले हुए हैं।</translation>
    </message>
    <message>
        <source>a list in it has the length %1.</source>
        <translation>इसमें एक सूची की लंबाई %1 है।</translation>
    </message>
    <message>
        <source>its points have no fixed places in the file (text, or lists). Save it as binary PLY, or as LAS.</source>
        <translation>फ़ाइल में इसके बिंदुओं की जगहें निश्चित नहीं हैं (पाठ, या सूचियाँ)। इसे बाइनरी PLY या LAS के रूप में सहेजें।</translation>
    </message>
    <message>
        <source>is too long for a PLY header</source>
        <translation>PLY फ़ाइल के शीर्ष के लिए बहुत लंबी है</translation>
    </message>
    <message>
        <source>names no known format</source>
        <translation>कोई ज्ञात प्रारूप नहीं बताती</translation>
    </message>
    <message>
        <source>holds no usable count</source>
        <translation>में कोई मान्य गिनती नहीं है</translation>
    </message>
    <message>
        <source>names an element a second time</source>
        <translation>किसी तत्व को दूसरी बार बताती है</translation>
    </message>
    <message>
        <source>belongs to no element</source>
        <translation>किसी तत्व की नहीं है</translation>
    </message>
    <message>
        <source>gives a list no whole-number length</source>
        <translation>सूची को पूर्णांक लंबाई नहीं देती</translation>
    </message>
    <message>
        <source>names an unknown type</source>
        <translation>कोई अज्ञात प्रकार बताती है</translation>
    </message>
    <message>
        <source>has no name</source>
        <translation>में नाम नहीं है</translation>
    </message>
    <message>
        <source>is one property too many</source>
        <translation>से गुणों की सीमा पार हो जाती है</translation>
    </message>
    <message>
        <source>names a property a second time</source>
        <translation>किसी गुण को दूसरी बार बताती है</translation>
    </message>
    <message>
        <source>its header %1 (line %2). It is no PCD file, or damaged; export it again.</source>
        <translation>शीर्ष %1 (पंक्ति %2)। यह PCD फ़ाइल नहीं है, या क्षतिग्रस्त है; इसे फिर से निर्यात करें।</translation>
    </message>
    <message>
        <source>has a line too long for a PCD file</source>
        <translation>में एक पंक्ति PCD फ़ाइल के लिए बहुत लंबी है</translation>
    </message>
    <message>
        <source>has no end (&quot;DATA&quot;)</source>
        <translation>का अंत (“DATA”) नहीं है</translation>
    </message>
    <message>
        <source>has too many fields</source>
        <translation>में बहुत अधिक फ़ील्ड हैं</translation>
    </message>
    <message>
        <source>holds no usable %1</source>
        <translation>में मान्य %1 नहीं है</translation>
    </message>
    <message>
        <source>names no known kind of data</source>
        <translation>डेटा का कोई ज्ञात प्रकार नहीं बताता</translation>
    </message>
    <message>
        <source>ends its lines with CR alone</source>
        <translation>अपनी पंक्तियाँ केवल CR से समाप्त करता है</translation>
    </message>
    <message>
        <source>names no fields</source>
        <translation>कोई फ़ील्ड नहीं बताता</translation>
    </message>
    <message>
        <source>does not give every field its SIZE, TYPE and COUNT</source>
        <translation>हर फ़ील्ड को उसका SIZE, TYPE और COUNT नहीं देता</translation>
    </message>
    <message>
        <source>gives field %1 an impossible SIZE or TYPE</source>
        <translation>फ़ील्ड %1 को असंभव SIZE या TYPE देता है</translation>
    </message>
    <message>
        <source>gives field %1 an impossible COUNT</source>
        <translation>फ़ील्ड %1 को असंभव COUNT देता है</translation>
    </message>
    <message>
        <source>has no single field %1</source>
        <translation>में ठीक एक फ़ील्ड %1 नहीं है</translation>
    </message>
    <message>
        <source>says nowhere how many points there are</source>
        <translation>कहीं नहीं बताता कि कितने बिंदु हैं</translation>
    </message>
    <message>
        <source>promises an impossible number of points</source>
        <translation>बिंदुओं की असंभव संख्या बताता है</translation>
    </message>
    <message>
        <source>promises %1 points, but %2 x %3</source>
        <translation>%1 बिंदु बताता है, पर आकार %2 x %3</translation>
    </message>
    <message>
        <source>it promises %1 points, more than the limit of %2. Thin it out first.</source>
        <translation>यह %1 बिंदु बताती है, जो %2 की सीमा से अधिक हैं। पहले इसे विरल करें।</translation>
    </message>
    <message>
        <source>its compressed data hold %1 bytes, not those of %2 points.</source>
        <translation>इसके संपीड़ित डेटा में %1 बाइट हैं, उतनी नहीं जितनी %2 बिंदुओं की होती हैं।</translation>
    </message>
    <message>
        <source>header promises %1 points, but the compressed data are cut, and no part of them can be read.</source>
        <translation>शीर्ष %1 बिंदु बताता है, पर संपीड़ित डेटा कटा हुआ है और उसका कोई भाग नहीं पढ़ा जा सकता।</translation>
    </message>
    <message>
        <source>it ends before &quot;endsolid&quot;. It is incomplete; copy or export it again.</source>
        <translation>यह “endsolid” से पहले समाप्त होती है। यह अधूरी है; इसे फिर से कॉपी या निर्यात करें।</translation>
    </message>
    <message>
        <source>it does not hold the chunks of a 3DS file.</source>
        <translation>इसमें 3DS फ़ाइल के भाग नहीं हैं।</translation>
    </message>
    <message>
        <source>it has no vertices (&quot;v x y z&quot;). Choose another file.</source>
        <translation>इसमें बिंदु (“v x y z”) नहीं हैं। दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message>
        <source>it promises more points than there can be.</source>
        <translation>यह जितने हो सकते हैं उससे अधिक बिंदु बताती है।</translation>
    </message>
    <message>
        <source>the matrix before line %1 does not place a scan.</source>
        <translation>पंक्ति %1 से पहले का आव्यूह किसी स्कैन की स्थिति तय नहीं करता।</translation>
    </message>
    <message>
        <source>line %1 (&quot;%2&quot;) should hold %3.</source>
        <translation>पंक्ति %1 (“%2”) में %3 चाहिए।</translation>
    </message>
    <message>
        <source>the number of columns of a scan</source>
        <translation>स्कैन के स्तंभों की संख्या</translation>
    </message>
    <message>
        <source>the number of rows of a scan</source>
        <translation>स्कैन की पंक्तियों की संख्या</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>तीन संख्याएँ</translation>
    </message>
    <message>
        <source>four numbers of a matrix</source>
        <translation>आव्यूह की चार संख्याएँ</translation>
    </message>
    <message>
        <source>a point&apos;s x, y and z</source>
        <translation>बिंदु के x, y और z</translation>
    </message>
    <message>
        <source>it says to be E57 version %1; this version reads E57 1. Export it again as E57 1.0.</source>
        <translation>यह स्वयं को E57 संस्करण %1 बताती है; relievo का यह संस्करण E57 1 पढ़ता है। इसे फिर से E57 1.0 के रूप में निर्यात करें।</translation>
    </message>
    <message>
        <source>its header gives an impossible page size.</source>
        <translation>शीर्ष पृष्ठ का असंभव आकार बताता है।</translation>
    </message>
    <message>
        <source>its length is no multiple of its pages.</source>
        <translation>इसकी लंबाई इसके पृष्ठों की लंबाई का गुणज नहीं है।</translation>
    </message>
    <message>
        <source>the checksum of its page %1 of %2 is wrong.</source>
        <translation>फ़ाइल के %2 में से पृष्ठ %1 का जाँच-योग ग़लत है।</translation>
    </message>
    <message>
        <source>it names a place outside itself.</source>
        <translation>फ़ाइल अपने से बाहर की जगह बताती है।</translation>
    </message>
    <message>
        <source>a part of it reaches beyond its end.</source>
        <translation>फ़ाइल का एक भाग उसके अंत से आगे जाता है।</translation>
    </message>
    <message>
        <source>its list of scans has an impossible length.</source>
        <translation>स्कैनों की सूची की लंबाई असंभव है।</translation>
    </message>
    <message>
        <source>its list of scans is no proper XML (%1).</source>
        <translation>स्कैनों की सूची सही XML नहीं है (%1)।</translation>
    </message>
    <message>
        <source>it lists no scans.</source>
        <translation>फ़ाइल की सूची में कोई स्कैन नहीं है।</translation>
    </message>
    <message>
        <source>a packet of its points makes no sense.</source>
        <translation>बिंदुओं का एक पैकेट निरर्थक है।</translation>
    </message>
    <message>
        <source>a section of its points makes no sense.</source>
        <translation>बिंदुओं का एक अनुभाग निरर्थक है।</translation>
    </message>
    <message>
        <source>it has no %1.</source>
        <translation>फ़ील्ड %1 नहीं है।</translation>
    </message>
    <message>
        <source>its entry in the list of scans %1.</source>
        <translation>स्कैनों की सूची में इसकी प्रविष्टि %1।</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot; in place of a number</source>
        <translation>में संख्या की जगह “%1” है</translation>
    </message>
    <message>
        <source>names an unknown codec</source>
        <translation>अज्ञात कोडेक बताती है</translation>
    </message>
    <message>
        <source>gives %1 a maximum below its minimum</source>
        <translation>%1 को न्यूनतम से छोटा अधिकतम देती है</translation>
    </message>
    <message>
        <source>holds a rotation that is no unit quaternion</source>
        <translation>में ऐसा घूर्णन है जो इकाई क्वाटर्नियन नहीं है</translation>
    </message>
    <message>
        <source>has points of an unknown kind</source>
        <translation>में अज्ञात प्रकार के बिंदु हैं</translation>
    </message>
    <message>
        <source>does not say what a point consists of</source>
        <translation>नहीं बताती कि बिंदु किससे बना है</translation>
    </message>
    <message>
        <source>it says to be LAS version %1.%2; versions 1.0 to 1.4 exist. Export it again as LAS 1.4.</source>
        <translation>यह स्वयं को LAS संस्करण %1.%2 बताती है; संस्करण 1.0 से 1.4 तक होते हैं। इसे फिर से LAS 1.4 के रूप में निर्यात करें।</translation>
    </message>
    <message>
        <source>it says to hold points of format %1; formats 0 to 10 exist.</source>
        <translation>यह अपने बिंदुओं का प्रारूप %1 बताती है; प्रारूप 0 से 10 तक होते हैं।</translation>
    </message>
    <message>
        <source>its header gives points of format %1 %2 bytes each; they need %3.</source>
        <translation>शीर्ष प्रारूप %1 के हर बिंदु को %2 बाइट देता है; %3 चाहिए।</translation>
    </message>
    <message>
        <source>its header places the points within itself.</source>
        <translation>शीर्ष के अनुसार बिंदु स्वयं शीर्ष के भीतर हैं।</translation>
    </message>
    <message>
        <source>its header holds no usable scale and offset of coordinates.</source>
        <translation>शीर्ष में निर्देशांकों का मान्य पैमाना और विस्थापन नहीं है।</translation>
    </message>
    <message>
        <source>it says its header has %1 bytes; %2 are needed.</source>
        <translation>यह अपने शीर्ष को %1 बाइट का बताती है; %2 चाहिए।</translation>
    </message>
    <message>
        <source>it packs %1 points in one block, which cannot be unpacked in parts. Read it as a whole, or pack it again in blocks of 50 000.</source>
        <translation>इसमें %1 बिंदु एक ही खंड में पैक हैं, जो भागों में नहीं खोला जा सकता। इसे पूरा एक साथ पढ़ें, या फिर से 50 000 के खंडों में पैक करें।</translation>
    </message>
    <message>
        <source>its record of packing names fields of kind %1 with %2 bytes, which do not exist there.</source>
        <translation>पैकिंग का अभिलेख प्रकार %1 के %2 बाइट वाले फ़ील्ड बताता है, जो वहाँ होते ही नहीं।</translation>
    </message>
    <message>
        <source>its points are packed by version %1 of the method, which is not known here.</source>
        <translation>इसके बिंदु विधि के संस्करण %1 से पैक हैं, जो यहाँ ज्ञात नहीं।</translation>
    </message>
    <message>
        <source>its points are packed in a way (%1) that is not known here.</source>
        <translation>इसके बिंदु ऐसे तरीके (%1) से पैक हैं जो यहाँ ज्ञात नहीं।</translation>
    </message>
    <message>
        <source>its record of packing is cut.</source>
        <translation>पैकिंग का अभिलेख कटा हुआ है।</translation>
    </message>
    <message>
        <source>its record of packing does not begin with the coordinates.</source>
        <translation>पैकिंग का अभिलेख निर्देशांकों से शुरू नहीं होता।</translation>
    </message>
    <message>
        <source>its record of packing is not for points of format %1.</source>
        <translation>पैकिंग का अभिलेख प्रारूप %1 के बिंदुओं के लिए नहीं है।</translation>
    </message>
    <message>
        <source>its header gives each point %1 bytes, its record of packing %2.</source>
        <translation>शीर्ष हर बिंदु को %1 बाइट देता है, पैकिंग का अभिलेख %2।</translation>
    </message>
    <message>
        <source>the list of its blocks of points %1.</source>
        <translation>बिंदु-खंडों की सूची %1।</translation>
    </message>
    <message>
        <source>lies within its header</source>
        <translation>शीर्ष के भीतर है</translation>
    </message>
    <message>
        <source>is none</source>
        <translation>वास्तव में कोई सूची नहीं है</translation>
    </message>
    <message>
        <source>its header promises %1 points, the list of its blocks others (%2 blocks).</source>
        <translation>शीर्ष %1 बिंदु बताता है, बिंदु-खंडों की सूची दूसरी संख्या (%2 खंड)।</translation>
    </message>
    <message>
        <source>it is a compressed LAS file, and no record in it says how its points are packed.</source>
        <translation>यह संपीड़ित LAS फ़ाइल है, और इसका कोई अभिलेख नहीं बताता कि बिंदु कैसे पैक हैं।</translation>
    </message>
    <message>
        <source>its header promises %1 points.</source>
        <translation>शीर्ष %1 बिंदु बताता है।</translation>
    </message>
    <message>
        <source>it ends before its points.</source>
        <translation>यह अपने बिंदुओं से पहले समाप्त होती है।</translation>
    </message>
    <message>
        <source>its block of points number %1 %2.</source>
        <translation>बिंदु-खंड क्रमांक %1 %2।</translation>
    </message>
    <message>
        <source>mixes fields of old and of new point formats</source>
        <translation>में पुराने और नए बिंदु-प्रारूपों के फ़ील्ड मिले हुए हैं</translation>
    </message>
    <message>
        <source>is shorter than its layers</source>
        <translation>की लंबाई इसकी परतों की लंबाई से कम है</translation>
    </message>
    <message>
        <source>ends within its list of layers</source>
        <translation>का अंत परतों की सूची के बीच में है</translation>
    </message>
    <message>
        <source>says another number of points than the list of chunks</source>
        <translation>में बताई गई बिंदुओं की संख्या खंडों की सूची की संख्या से अलग है</translation>
    </message>
    <message>
        <source>holds no coordinates</source>
        <translation>में निर्देशांक नहीं हैं</translation>
    </message>
    <message>
        <source>ends before its last point</source>
        <translation>का अंत आख़िरी बिंदु से पहले है</translation>
    </message>
    <message>
        <source>ends before its first point</source>
        <translation>का अंत प्रथम बिंदु से पहले है</translation>
    </message>
    <message>
        <source>names more bytes than there are</source>
        <translation>में बताई गई बाइटें मौजूद बाइटों से अधिक हैं</translation>
    </message>
    <message>
        <source>holds bytes that no coder writes</source>
        <translation>में ऐसी बाइटें हैं जो कोई कोडर नहीं लिखता</translation>
    </message>
    <message>
        <source>switches between sequences of times without end</source>
        <translation>में समय के अनुक्रमों के बीच अंतहीन अदला-बदली है</translation>
    </message>
    <message>
        <source>its COPC hierarchy %1.</source>
        <translation>COPC पदानुक्रम %1।</translation>
    </message>
    <message>
        <source>leaves out points that the file holds</source>
        <translation>फ़ाइल के कुछ बिंदु छोड़ देता है</translation>
    </message>
    <message>
        <source>has a page outside the file or of odd size</source>
        <translation>में एक पृष्ठ फ़ाइल से बाहर या अनुपयुक्त आकार का है</translation>
    </message>
    <message>
        <source>leads in a circle</source>
        <translation>चक्र में जाता है</translation>
    </message>
    <message>
        <source>has a node outside its octree</source>
        <translation>का एक नोड अपने ऑक्ट्री से बाहर है</translation>
    </message>
    <message>
        <source>names points that are no block of the file</source>
        <translation>ऐसे बिंदु बताता है जो फ़ाइल का कोई खंड नहीं हैं</translation>
    </message>
    <message>
        <source>names a block of points twice</source>
        <translation>एक बिंदु-खंड को दो बार बताता है</translation>
    </message>
    <message>
        <source>has no root</source>
        <translation>में मूल नोड नहीं है</translation>
    </message>
    <message>
        <source>header promises %1 cells, file ends at %2.</source>
        <translation>शीर्ष %1 कोशिकाएँ बताता है, फ़ाइल %2 पर समाप्त होती है।</translation>
    </message>
    <message>
        <source>it has not the bands that colours of a map have.</source>
        <translation>इसमें वे बैंड नहीं हैं जो मानचित्र के रंगों में होते हैं।</translation>
    </message>
    <message>
        <source>row %1 is damaged or missing.</source>
        <translation>पंक्ति %1 क्षतिग्रस्त या अनुपस्थित है।</translation>
    </message>
    <message>
        <source>it carries %1 bytes of metadata, more than the limit of %2. Export it again without them.</source>
        <translation>इसमें %1 बाइट मेटाडेटा है, जो %2 की सीमा से अधिक है। इसे मेटाडेटा के बिना फिर से निर्यात करें।</translation>
    </message>
    <message>
        <source>it is not a readable %1. Export it again as GeoTIFF.</source>
        <translation>यह पढ़ने योग्य %1 नहीं है। इसे फिर से GeoTIFF के रूप में निर्यात करें।</translation>
    </message>
    <message>
        <source>it is not a readable %1 (%2). Export it again as GeoTIFF.</source>
        <translation>यह पढ़ने योग्य %1 नहीं है (%2)। इसे फिर से GeoTIFF के रूप में निर्यात करें।</translation>
    </message>
    <message>
        <source>its georeference holds no usable numbers. Write it again with gdal_translate.</source>
        <translation>इसके भू-संदर्भ में मान्य संख्याएँ नहीं हैं। इसे gdal_translate से फिर से लिखें।</translation>
    </message>
    <message>
        <source>its rows do not run from west to east; it is rotated or mirrored. Make it north-up with gdalwarp.</source>
        <translation>इसकी पंक्तियाँ पश्चिम से पूर्व की ओर नहीं जातीं; रास्टर घूमा हुआ या दर्पण-उलटा है। इसे gdalwarp से ऐसा बनाएँ कि उत्तर ऊपर हो।</translation>
    </message>
    <message>
        <source>its pixels are not square (%1). Resample it with gdalwarp -tr.</source>
        <translation>इसके पिक्सेल वर्गाकार नहीं हैं (%1)। इसके नमूने gdalwarp -tr से फिर से लें।</translation>
    </message>
    <message>
        <source>its cells are complex numbers, not heights. Choose a height raster.</source>
        <translation>इसकी कोशिकाएँ सम्मिश्र संख्याएँ हैं, ऊँचाइयाँ नहीं। ऊँचाई रास्टर चुनें।</translation>
    </message>
    <message>
        <source>each of its strips or tiles holds %1 MB; they are read whole, and 1 073 MB is the limit. Write one band of it again with gdal_translate -b 1 -co TILED=YES.</source>
        <translation>इसकी हर पट्टी या टाइल %1 MB की है; वे पूरी पढ़ी जाती हैं, और सीमा 1 073 MB है। इसका एक बैंड gdal_translate -b 1 -co TILED=YES से फिर से लिखें।</translation>
    </message>
    <message>
        <source>none of its %1 cells holds a height. Choose another raster.</source>
        <translation>इसकी %1 कोशिकाओं में से किसी में ऊँचाई नहीं है। दूसरा रास्टर चुनें।</translation>
    </message>
    <message>
        <source>row %1 is damaged or missing (%2).</source>
        <translation>पंक्ति %1 क्षतिग्रस्त या अनुपस्थित है (%2)।</translation>
    </message>
    <message>
        <source>it holds the origins of a map&apos;s cells, not heights. Open the map beside it.</source>
        <translation>इसमें मानचित्र की कोशिकाओं के उद्गम हैं, ऊँचाइयाँ नहीं। इसके साथ वाला मानचित्र खोलें।</translation>
    </message>
    <message>
        <source>its RELIEVO_ entries were changed and make no sense.</source>
        <translation>इसकी RELIEVO_ प्रविष्टियाँ बदली गई हैं और निरर्थक हैं।</translation>
    </message>
    <message>
        <source>it has %1 x %2 cells; at least 2 x 2 are needed. Choose a larger raster.</source>
        <translation>इसमें %1 x %2 कोशिकाएँ हैं; कम से कम 2 x 2 चाहिए। बड़ा रास्टर चुनें।</translation>
    </message>
    <message>
        <source>it has %1 cells, more than the limit of %2. Cut or thin it with gdal_translate.</source>
        <translation>इसमें %1 कोशिकाएँ हैं, जो %2 की सीमा से अधिक हैं। इसे gdal_translate से काटें या विरल करें।</translation>
    </message>
    <message>
        <source>its heights could not be kept while they were used, or its reader broke down on it. Try again, or export it again.</source>
        <translation>इसकी ऊँचाइयाँ काम में लेते समय रखी नहीं जा सकीं, या पढ़ने वाला प्रोग्राम इस पर टूट गया। फिर कोशिश करें, या इसे फिर से निर्यात करें।</translation>
    </message>
    <message>
        <source>its points cannot be kept while they are used. Free some memory, and try again.</source>
        <translation>इसके बिंदु काम में लेते समय रखे नहीं जा सकते। कुछ स्मृति खाली करें और फिर कोशिश करें।</translation>
    </message>
    <message>
        <source>only LAS, LAZ and binary PLY files are read in blocks. Convert it to LAS first.</source>
        <translation>खंडों में केवल LAS, LAZ और बाइनरी PLY फ़ाइलें पढ़ी जाती हैं। पहले इसे LAS में बदलें।</translation>
    </message>
    <message>
        <source>this import program reads no rasters. Install relievo again.</source>
        <translation>यह आयात प्रोग्राम रास्टर नहीं पढ़ता। relievo फिर से इंस्टॉल करें।</translation>
    </message>
    <message>
        <source>it takes more than %1 s of processor time. Thin it out or cut it into parts first.</source>
        <translation>इसे %1 s से अधिक प्रोसेसर समय चाहिए। पहले इसे विरल करें या भागों में बाँटें।</translation>
    </message>
    <message>
        <source>it needs more than %1 MB of memory. Thin it out or cut it into parts first.</source>
        <translation>इसे %1 MB से अधिक मेमोरी चाहिए। पहले इसे विरल करें या भागों में काटें।</translation>
    </message>
    <message>
        <source>what it holds is passed on as a file, and files may have no more than %1 kB here (ulimit -f). Allow larger ones and try again.</source>
        <translation>इसकी सामग्री फ़ाइल के रूप में आगे दी जाती है, और यहाँ फ़ाइलें %1 kB से बड़ी नहीं हो सकतीं (ulimit -f)। बड़ी फ़ाइलों की अनुमति दें और फिर से प्रयास करें।</translation>
    </message>
    <message>
        <source>its reader gave up (%1).</source>
        <translation>इसके पाठक-प्रोग्राम ने हार मान ली (%1)।</translation>
    </message>
    <message>
        <source>PCL gave up on its points. The program&apos;s own reader may take them (--reader own).</source>
        <translation>PCL ने इसके बिंदुओं पर हार मान ली। प्रोग्राम का अपना पाठक शायद उन्हें ले सके (--reader own)।</translation>
    </message>
    <message>
        <source>its reader broke down on it. The program is unharmed; the file is probably damaged. Export it again.</source>
        <translation>पढ़ने वाला प्रोग्राम इस पर टूट गया। मुख्य प्रोग्राम सुरक्षित है; फ़ाइल संभवतः क्षतिग्रस्त है। इसे फिर से निर्यात करें।</translation>
    </message>
    <message>
        <source>its reader broke down on it (&quot;%1&quot;). The program is unharmed; the file is probably damaged. Export it again.</source>
        <translation>पढ़ने वाला प्रोग्राम इस पर टूट गया (“%1”)। मुख्य प्रोग्राम सुरक्षित है; फ़ाइल संभवतः क्षतिग्रस्त है। इसे फिर से निर्यात करें।</translation>
    </message>
    <message>
        <source>a raster keeps its cells and heights.</source>
        <translation>रास्टर अपनी कोशिकाएँ और ऊँचाइयाँ बनाए रखता है।</translation>
    </message>
    <message>
        <source>a map that relievo wrote is taken as it is.</source>
        <translation>relievo का लिखा मानचित्र जैसा है वैसा ही लिया जाता है।</translation>
    </message>
    <message>
        <source>a raster that relievo did not write</source>
        <translation>ऐसा रास्टर जिसे relievo ने नहीं लिखा</translation>
    </message>
    <message>
        <source>%1 changes nothing here: %2</source>
        <translation>%1 से यहाँ कुछ नहीं बदलता: %2</translation>
    </message>
    <message>
        <source>%1 is %2, above %3, which is %4.</source>
        <translation>%1 %2 है, जो %3 (%4) से अधिक है।</translation>
    </message>
    <message>
        <source>Closer. %1 wide.</source>
        <translation>पास। चौड़ाई %1।</translation>
    </message>
    <message>
        <source>Wider. %1 wide.</source>
        <translation>चौड़ा। चौड़ाई %1।</translation>
    </message>
    <message>
        <source>The whole relief.</source>
        <translation>पूरा उभार।</translation>
    </message>
    <message>
        <source>%1 of %2 points {1|lies|lie} %3 of the box away from all others; surfaces are made without {1|it|them}, unless --strays keep is given.</source>
        <translation>%2 में से %1 {1|बिंदु बाकी सबसे बॉक्स के %3 दूर है; सतहें उसके|बिंदु बाकी सबसे बॉक्स के %3 दूर हैं; सतहें उनके} बिना बनती हैं, जब तक --strays keep न दिया जाए।</translation>
    </message>
    <message>
        <source>{1|%1 vertex belongs|%1 vertices belong} to no face and {1|lies|lie} outside of the object; surfaces are made without {1|it|them}, unless --strays keep is given.</source>
        <translation>{1|%1 शीर्ष किसी फलक का नहीं है और वस्तु के बाहर है; सतहें उसके|%1 शीर्ष किसी फलक के नहीं हैं और वस्तु के बाहर हैं; सतहें उनके} बिना बनती हैं, जब तक --strays keep न दिया जाए।</translation>
    </message>
    <message>
        <source>%1 of %2 points lie together %3 of the box away from all others; surfaces are made with them, as they may belong to the object, unless --strays drop-groups is given.</source>
        <translation>%2 में से %1 बिंदु एक साथ बाकी सबसे बॉक्स के %3 दूर हैं; सतहें उनके साथ बनती हैं, क्योंकि वे वस्तु के हो सकते हैं, जब तक --strays drop-groups न दिया जाए।</translation>
    </message>
    <message>
        <source>%1 of %2 heights are %3, which often stands for a missing one; surfaces are made without them, unless --nodata none is given.</source>
        <translation>%2 में से %1 ऊँचाइयाँ %3 हैं, जो अक्सर लापता ऊँचाई के लिए लिखा जाता है; सतहें उनके बिना बनती हैं, जब तक --nodata none न दिया जाए।</translation>
    </message>
    <message>
        <source>Several processes make one map by tiles only, and through a folder that all of them see. Nothing was made. Give --memory and --job as well.</source>
        <translation>कई प्रक्रियाएँ मिलकर केवल टाइलों में नक़्शा बनाती हैं, और ऐसे फ़ोल्डर के द्वारा जिसे वे सब देखती हैं। कुछ नहीं बनाया गया। --memory और --job भी दें।</translation>
    </message>
    <message>
        <source>Process %1 of %2 has other work than the first: %3 differs. Nothing was made. Start all of them with the same command and version, where all see the same files.</source>
        <translation>प्रक्रिया %1, कुल %2 में से, का काम पहली से अलग है: %3 अलग है। कुछ नहीं बनाया गया। सबको एक ही आदेश और एक ही संस्करण से वहाँ शुरू करें जहाँ सबको एक ही फ़ाइलें दिखती हैं।</translation>
    </message>
    <message>
        <source>Process %1 of %2: %3</source>
        <translation>प्रक्रिया %1, कुल %2 में से: %3</translation>
    </message>
</context>
<context>
    <name>relievo::MessageStrip</name>
    <message>
        <source>Message</source>
        <translation>संदेश</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>यह संदेश बंद करें</translation>
    </message>
    <message>
        <source>Close message</source>
        <translation>संदेश बंद करें</translation>
    </message>
    <message>
        <source>Key of the first button</source>
        <translation>पहले बटन की कुंजी</translation>
    </message>
</context>
<context>
    <name>relievo::NoteDialog</name>
    <message>
        <source>Note</source>
        <translation>टिप्पणी</translation>
    </message>
    <message>
        <source>&amp;Note at %1 s of the recording</source>
        <translation>रिकॉर्डिंग के %1 s पर टिप्पणी (&amp;N)</translation>
    </message>
    <message>
        <source>At %1 s of the recording</source>
        <translation>रिकॉर्डिंग के %1 s पर</translation>
    </message>
    <message>
        <source>What was seen or felt, in a few words</source>
        <translation>क्या दिखा या महसूस हुआ, थोड़े शब्दों में</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>जोड़ें (&amp;A)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>जोड़ें</translation>
    </message>
    <message>
        <source>Write the note into the recording</source>
        <translation>टिप्पणी को रिकॉर्डिंग में लिखें</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>रद्द करें (&amp;C)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>रद्द करें</translation>
    </message>
    <message>
        <source>Close without a note</source>
        <translation>बिना टिप्पणी बंद करें</translation>
    </message>
</context>
<context>
    <name>relievo::OpenController</name>
    <message>
        <source>%1 needs %2, which has moved. Nothing was changed. Find it, or choose another file. (E501)</source>
        <translation>%1 को %2 चाहिए, जो हट गई है। कुछ नहीं बदला। उसे ढूँढें या दूसरी फ़ाइल चुनें। (E501)</translation>
    </message>
    <message>
        <source>&amp;Find it…</source>
        <translation>ढूँढें (&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Choose another…</source>
        <translation>दूसरी चुनें (&amp;C)…</translation>
    </message>
    <message>
        <source>Find %1</source>
        <translation>%1 ढूँढें</translation>
    </message>
    <message>
        <source>%1 has changed since this was saved (its checksum differs). It is shown as it is now; results may differ. (E501)</source>
        <translation>सहेजने के बाद %1 बदल गई है (चेकसम अलग है)। यह अब जैसी है वैसी दिखाई गई है; परिणाम अलग हो सकते हैं। (E501)</translation>
    </message>
    <message>
        <source>&amp;Work that was kept…</source>
        <translation>रखा गया काम (&amp;W)…</translation>
    </message>
    <message>
        <source>&amp;Load what is there</source>
        <translation>जो है उसे लोड करें (&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>चुनें (&amp;C)…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>खोलें</translation>
    </message>
    <message>
        <source>Scans, height maps, projects and figures (%1)</source>
        <translation>स्कैन, ऊँचाई मानचित्र, परियोजनाएँ और चित्र (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>सभी फ़ाइलें (*)</translation>
    </message>
    <message>
        <source>%1 was not opened: it needs %2, which is outside of its folder and was not read. Nothing was changed. Find it, or choose another file.</source>
        <translation>%1 नहीं खोला गया: इसे %2 चाहिए, जो इसके फ़ोल्डर से बाहर है और नहीं पढ़ा गया। कुछ नहीं बदला गया। उसे खोजें, या कोई दूसरी फ़ाइल चुनें।</translation>
    </message>
    <message numerus="yes">
        <source>relievo ended unexpectedly. Work on %1 of %2 was kept (%n step(s)).</source>
        <translation>
            <numerusform>relievo अप्रत्याशित रूप से बंद हुआ। %2 का %1 पर काम रखा गया है (%n चरण)।</numerusform>
            <numerusform>relievo अप्रत्याशित रूप से बंद हुआ। %2 का %1 पर काम रखा गया है (%n चरण)।</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>वापस लाएँ (&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>छोड़ दें (&amp;D)</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>फ़ोल्डर खोलें</translation>
    </message>
    <message>
        <source>There is no scan in %1. Nothing was opened.</source>
        <translation>%1 में कोई स्कैन नहीं है। कुछ नहीं खोला गया।</translation>
    </message>
    <message>
        <source>%1 files are more than the %2 scans that can be joined. Nothing was opened.</source>
        <translation>%1 फ़ाइलें जोड़े जा सकने वाले %2 स्कैन से अधिक हैं। कुछ नहीं खोला गया।</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>तैयार करें</translation>
    </message>
    <message>
        <source>The next file is seen like this one.</source>
        <translation>अगली फ़ाइल इसी की तरह दिखेगी।</translation>
    </message>
    <message>
        <source>The next file is seen from its own best side.</source>
        <translation>अगली फ़ाइल अपनी सबसे अच्छी ओर से दिखेगी।</translation>
    </message>
    <message>
        <source>&amp;Load one point in %1</source>
        <translation>%1 में से एक बिंदु लोड करें (&amp;L)</translation>
    </message>
    <message>
        <source>%1 shows the map at %2, which was not opened on this computer yet. Nothing was changed. To open it asks that server.</source>
        <translation>%1 में %2 का मानचित्र है, जो इस कंप्यूटर पर अभी तक नहीं खोला गया। कुछ नहीं बदला गया। खोलने पर उस सर्वर से पूछा जाएगा।</translation>
    </message>
    <message>
        <source>The work that was kept</source>
        <translation>रखा गया काम</translation>
    </message>
    <message>
        <source>&amp;Open the map</source>
        <translation>मानचित्र खोलें (&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>फिर कोशिश (&amp;T)</translation>
    </message>
    <message>
        <source>Another &amp;address…</source>
        <translation>दूसरा पता (&amp;A)…</translation>
    </message>
    <message>
        <source>A map is opened by its address alone, without other files. Nothing was opened.</source>
        <translation>मानचित्र अपने पते से अकेले खोला जाता है, दूसरी फ़ाइलों के बिना। कुछ नहीं खोला गया।</translation>
    </message>
</context>
<context>
    <name>relievo::OverviewInset</name>
    <message>
        <source>Place of the window on the object</source>
        <translation>वस्तु पर विंडो की जगह</translation>
    </message>
</context>
<context>
    <name>relievo::PackageController</name>
    <message>
        <source>Cancelled. Nothing was packed.</source>
        <translation>रद्द किया गया। कुछ नहीं पैक हुआ।</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was opened.</source>
        <translation>रद्द किया गया। कुछ नहीं खोला गया।</translation>
    </message>
    <message numerus="yes">
        <source>%1 is packed: %n file(s), each with its checksum</source>
        <translation>
            <numerusform>%1 पैक हुआ: %n फ़ाइल, अपने जाँच-योग के साथ</numerusform>
            <numerusform>%1 पैक हुआ: %n फ़ाइलें, हर एक अपने जाँच-योग के साथ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n part(s) of %1 are not as they were packed. Nothing was opened. &apos;relievo project verify&apos; names them.</source>
        <translation>
            <numerusform>%1 का %n भाग वैसा नहीं है जैसा पैक किया गया था। कुछ नहीं खोला गया। &apos;relievo project verify&apos; उसका नाम बताता है।</numerusform>
            <numerusform>%1 के %n भाग वैसे नहीं हैं जैसे पैक किए गए थे। कुछ नहीं खोला गया। &apos;relievo project verify&apos; उनके नाम बताता है।</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Unpack elsewhere…</source>
        <translation>&amp;कहीं और खोलें…</translation>
    </message>
    <message>
        <source>%1 was unpacked into %2</source>
        <translation>%1 को %2 में निकाला गया</translation>
    </message>
    <message>
        <source>Unpack %1 into</source>
        <translation>%1 को यहाँ निकालें</translation>
    </message>
</context>
<context>
    <name>relievo::PackageDialog</name>
    <message>
        <source>One zip with this work as a project, what is ticked here, a README, and the checksum of each file. Recordings bring the rasters along that they need to be repeated.</source>
        <translation>एक zip फ़ाइल: यह काम परियोजना के रूप में, यहाँ चुना हुआ, एक README और हर फ़ाइल का जाँच-योग। रिकॉर्डिंग अपने साथ वे रास्टर लाती हैं जो दोहराने के लिए चाहिए।</translation>
    </message>
    <message>
        <source>The &amp;scan %1, %2</source>
        <translation>स्कैन %1, %2 (&amp;S)</translation>
    </message>
    <message>
        <source>The scan %1</source>
        <translation>स्कैन %1</translation>
    </message>
    <message>
        <source>Off: only its name and checksum, if it may not be given away</source>
        <translation>बंद: केवल नाम और जाँच-योग, यदि वह किसी को नहीं दिया जा सकता</translation>
    </message>
    <message>
        <source>Recordings and &amp;figures</source>
        <translation>रिकॉर्डिंग और चित्र (&amp;F)</translation>
    </message>
    <message>
        <source>Recordings and figures</source>
        <translation>रिकॉर्डिंग और चित्र</translation>
    </message>
    <message>
        <source>Ticked files are packed</source>
        <translation>चुनी हुई फ़ाइलें पैक होती हैं</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>जोड़ें… (&amp;A)</translation>
    </message>
    <message>
        <source>Take another recording or figure along</source>
        <translation>एक और रिकॉर्डिंग या चित्र साथ लें</translation>
    </message>
    <message>
        <source>&amp;Package</source>
        <translation>पैकेज (&amp;P)</translation>
    </message>
    <message>
        <source>Package</source>
        <translation>पैकेज</translation>
    </message>
    <message>
        <source>Where the package is saved</source>
        <translation>पैकेज कहाँ सहेजा जाए</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>ब्राउज़ करें… (&amp;B)</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>दूसरी जगह चुनें</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>रिकॉर्डिंग %1</translation>
    </message>
    <message>
        <source>Figure %1</source>
        <translation>चित्र %1</translation>
    </message>
    <message>
        <source>Take along</source>
        <translation>साथ लें</translation>
    </message>
    <message>
        <source>Recordings and figures (*.csv *.h5 *.hdf5 *.png *.tif *.tiff *.pdf *.svg)</source>
        <translation>रिकॉर्डिंग और चित्र (*.csv *.h5 *.hdf5 *.png *.tif *.tiff *.pdf *.svg)</translation>
    </message>
    <message>
        <source>Packages (*.zip)</source>
        <translation>पैकेज (*.zip)</translation>
    </message>
    <message>
        <source>Export archive package</source>
        <translation>संग्रह पैकेज निर्यात</translation>
    </message>
    <message>
        <source>The map %1, by its address</source>
        <translation>मानचित्र %1, उसके पते से</translation>
    </message>
    <message>
        <source>Of a map on the web only what was looked at is on this computer</source>
        <translation>वेब के मानचित्र का केवल वही भाग इस कंप्यूटर पर है जो देखा गया</translation>
    </message>
</context>
<context>
    <name>relievo::PairPicking</name>
    <message>
        <source>The scans are still being read</source>
        <translation>स्कैन अभी पढ़े जा रहे हैं</translation>
    </message>
    <message>
        <source>Scan %1: %2</source>
        <translation>स्कैन %1: %2</translation>
    </message>
    <message>
        <source>Reference: %1</source>
        <translation>संदर्भ: %1</translation>
    </message>
    <message>
        <source>Now place %1 on the reference</source>
        <translation>अब संदर्भ पर जगह %1</translation>
    </message>
    <message>
        <source>Now place %1 on the scan</source>
        <translation>अब स्कैन पर जगह %1</translation>
    </message>
    <message>
        <source>Choose place %1 on the scan, then the same on the reference</source>
        <translation>स्कैन पर जगह %1 चुनें, फिर वही संदर्भ पर</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s). Escape or the button ends; more pairs do no harm.</source>
        <translation>
            <numerusform>%n जोड़ा। Escape या बटन से समाप्त; अधिक जोड़ों से हानि नहीं।</numerusform>
            <numerusform>%n जोड़े। Escape या बटन से समाप्त; अधिक जोड़ों से हानि नहीं।</numerusform>
        </translation>
    </message>
    <message>
        <source>They fit to %1 mm; pair %2 fits worst, %3 mm.</source>
        <translation>वे %1 mm तक मेल खाते हैं; जोड़ा %2 सबसे कम मेल खाता है, %3 mm।</translation>
    </message>
</context>
<context>
    <name>relievo::PictureController</name>
    <message>
        <source>Cancelled. No picture was saved.</source>
        <translation>रद्द किया गया। कोई चित्र नहीं सहेजा गया।</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 सहेजी गई</translation>
    </message>
    <message>
        <source>%1 is saved in %2</source>
        <translation>%1 %2 में सहेजा गया</translation>
    </message>
</context>
<context>
    <name>relievo::PlaceController</name>
    <message>
        <source>%1 removed.</source>
        <translation>%1 हटाया गया।</translation>
    </message>
    <message>
        <source>%1 set.</source>
        <translation>%1 लगाया गया।</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>%1 पर जाएँ</translation>
    </message>
    <message>
        <source>The view is copied as text</source>
        <translation>दृश्य पाठ के रूप में कॉपी हुआ</translation>
    </message>
    <message>
        <source>The copied view does not lie on this map. The window was not moved. Open the scan that it was copied from.</source>
        <translation>कॉपी किया गया दृश्य इस मानचित्र पर नहीं है। विंडो नहीं खिसकाई गई। वह स्कैन खोलें जिससे दृश्य कॉपी किया गया था।</translation>
    </message>
    <message>
        <source>Paste view</source>
        <translation>दृश्य चिपकाएँ</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>चिह्न %1</translation>
    </message>
    <message>
        <source>There are %1 markers already. Remove one first.</source>
        <translation>पहले से %1 चिह्न हैं। पहले एक हटाएँ।</translation>
    </message>
    <message>
        <source>%1 is in the window already.</source>
        <translation>%1 पहले से विंडो में है।</translation>
    </message>
    <message>
        <source>%1 has a finer resolution than this map. The window was not moved.</source>
        <translation>%1 का रिज़ॉल्यूशन इस मानचित्र से बारीक है। विंडो नहीं खिसकाई गई।</translation>
    </message>
    <message>
        <source>%1. Resolution %2 of %3</source>
        <translation>%1। रिज़ॉल्यूशन %3 में से %2</translation>
    </message>
    <message>
        <source>The copied view is shown. Resolution %1 of %2</source>
        <translation>कॉपी किया गया दृश्य दिखाया गया। रिज़ॉल्यूशन %2 में से %1</translation>
    </message>
</context>
<context>
    <name>relievo::PlacesPanel</name>
    <message>
        <source>With light and view</source>
        <translation>प्रकाश और दृश्य के साथ</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>जाएँ</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>नाम बदलें</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>हटाएँ</translation>
    </message>
    <message>
        <source>%1 is forgotten</source>
        <translation>%1 भुलाई गई</translation>
    </message>
    <message>
        <source>Add bookmark</source>
        <translation>बुकमार्क जोड़ें</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>बुकमार्क</translation>
    </message>
    <message>
        <source>Enter goes to a bookmark, F2 renames it, Delete removes it</source>
        <translation>Enter बुकमार्क पर जाता है, F2 नाम बदलता है, Delete हटाता है</translation>
    </message>
    <message>
        <source>A new bookmark also keeps light, relief image, stereo and the turn of the view</source>
        <translation>नया बुकमार्क प्रकाश, उभार का चित्र, स्टीरियो और दृश्य का घुमाव भी रखता है</translation>
    </message>
    <message>
        <source>Keep the window under a name (Ctrl+N)</source>
        <translation>विंडो को नाम देकर रखें (Ctrl+N)</translation>
    </message>
    <message>
        <source>Move the window to the selected bookmark</source>
        <translation>विंडो को चुने हुए बुकमार्क पर ले जाएँ</translation>
    </message>
    <message>
        <source>Change the selected bookmark&apos;s name (F2)</source>
        <translation>चुने हुए बुकमार्क का नाम बदलें (F2)</translation>
    </message>
    <message>
        <source>Delete the selected bookmark</source>
        <translation>चुना हुआ बुकमार्क हटाएँ</translation>
    </message>
    <message>
        <source>Bookmark %1</source>
        <translation>बुकमार्क %1</translation>
    </message>
    <message>
        <source>There is no bookmark yet</source>
        <translation>अभी कोई बुकमार्क नहीं है</translation>
    </message>
    <message>
        <source>The window alone</source>
        <translation>केवल विंडो</translation>
    </message>
</context>
<context>
    <name>relievo::PointerBindings</name>
    <message>
        <source>left turns</source>
        <translation>बायाँ घुमाता है</translation>
    </message>
    <message>
        <source>left moves</source>
        <translation>बायाँ खिसकाता है</translation>
    </message>
    <message>
        <source>left zooms</source>
        <translation>बायाँ पास-दूर करता है</translation>
    </message>
    <message>
        <source>middle turns</source>
        <translation>बीच का घुमाता है</translation>
    </message>
    <message>
        <source>middle moves</source>
        <translation>बीच का खिसकाता है</translation>
    </message>
    <message>
        <source>middle zooms</source>
        <translation>बीच का पास-दूर करता है</translation>
    </message>
    <message>
        <source>right turns</source>
        <translation>दायाँ घुमाता है</translation>
    </message>
    <message>
        <source>right moves</source>
        <translation>दायाँ खिसकाता है</translation>
    </message>
    <message>
        <source>right zooms</source>
        <translation>दायाँ पास-दूर करता है</translation>
    </message>
    <message>
        <source>left presses the hand in</source>
        <translation>बायाँ हाथ को भीतर दबाता है</translation>
    </message>
    <message>
        <source>wheel zooms</source>
        <translation>पहिया पास-दूर करता है</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>देखना</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>स्पर्श</translation>
    </message>
    <message>
        <source>turn the view</source>
        <translation>दृश्य घुमाएँ</translation>
    </message>
    <message>
        <source>move the window</source>
        <translation>विंडो खिसकाएँ</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>पास-दूर करें</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>कुछ नहीं</translation>
    </message>
</context>
<context>
    <name>relievo::PointerController</name>
    <message>
        <source>What the mouse does in the detail view; F7 changes between look and touch, Preferences choose the buttons</source>
        <translation>माउस विवरण दृश्य में क्या करता है; F7 देखने और स्पर्श के बीच बदलता है, वरीयताएँ बटन चुनती हैं</translation>
    </message>
    <message>
        <source>The mouse feels the surface; Escape ends it</source>
        <translation>माउस सतह महसूस करता है; Escape इसे समाप्त करता है</translation>
    </message>
    <message>
        <source>The mouse no longer feels the surface</source>
        <translation>माउस अब सतह महसूस नहीं करता</translation>
    </message>
</context>
<context>
    <name>relievo::PreferencesDialog</name>
    <message>
        <source>No setting has these words.</source>
        <translation>इन शब्दों वाली कोई सेटिंग नहीं है।</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>वरीयताएँ</translation>
    </message>
    <message>
        <source>Search settings</source>
        <translation>सेटिंग खोजें</translation>
    </message>
    <message>
        <source>Words of a setting&apos;s name or explanation</source>
        <translation>सेटिंग के नाम या व्याख्या के शब्द</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>पन्ने</translation>
    </message>
    <message>
        <source>&amp;Defaults of this page</source>
        <translation>इस पन्ने के मूल मान (&amp;D)</translation>
    </message>
    <message>
        <source>Defaults of this page</source>
        <translation>इस पन्ने के मूल मान</translation>
    </message>
    <message>
        <source>Every setting of this page as it was at first</source>
        <translation>इस पन्ने की हर सेटिंग जैसी पहले थी</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>ढूँढें (&amp;B)…</translation>
    </message>
    <message>
        <source>Browse for %1</source>
        <translation>%1 ढूँढें</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>रूप</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>रंग</translation>
    </message>
    <message>
        <source>Light, dark or high contrast window; or as the desktop</source>
        <translation>हल्की, गहरी या उच्च कंट्रास्ट खिड़की; या डेस्कटॉप जैसी</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>प्रणाली जैसा</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>हल्का</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>गहरा</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>उच्च कंट्रास्ट</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>पाठ का आकार</translation>
    </message>
    <message>
        <source>Of the system&apos;s text size; everything grows with it</source>
        <translation>प्रणाली के पाठ आकार का; सब कुछ साथ बढ़ता है</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>भाषा</translation>
    </message>
    <message>
        <source>Of the window; holds from the next start</source>
        <translation>खिड़की की; अगली शुरुआत से लागू</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>इकाइयाँ</translation>
    </message>
    <message>
        <source>Ask</source>
        <translation>पूछें</translation>
    </message>
    <message>
        <source>Files without a unit</source>
        <translation>बिना इकाई की फ़ाइलें</translation>
    </message>
    <message>
        <source>Which unit is taken where neither the file nor its folder says one</source>
        <translation>जहाँ न फ़ाइल न उसका फ़ोल्डर इकाई बताए, वहाँ कौन-सी ली जाए</translation>
    </message>
    <message>
        <source>Sizes are shown in</source>
        <translation>आकार दिखाने की इकाई</translation>
    </message>
    <message>
        <source>Millimetres, and metres for what is larger than 10 m; or always one unit</source>
        <translation>मिलीमीटर, और 10 m से बड़े के लिए मीटर; या हमेशा एक इकाई</translation>
    </message>
    <message>
        <source>Fitting unit</source>
        <translation>उपयुक्त इकाई</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>मिलीमीटर</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>सेंटीमीटर</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>मीटर</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>इंच</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>स्टीरियो</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>धूसर</translation>
    </message>
    <message>
        <source>Half colour</source>
        <translation>अर्ध-रंग</translation>
    </message>
    <message>
        <source>Dubois</source>
        <translation>Dubois</translation>
    </message>
    <message>
        <source>Eye separation</source>
        <translation>आँखों की दूरी</translation>
    </message>
    <message>
        <source>Keep comfortable</source>
        <translation>आरामदायक रखें</translation>
    </message>
    <message>
        <source>Less eye separation where it would pass 1 degree of parallax</source>
        <translation>जहाँ लंबन 1 डिग्री से बढ़े वहाँ आँखों की कम दूरी</translation>
    </message>
    <message>
        <source>Swap eyes</source>
        <translation>आँखें बदलें</translation>
    </message>
    <message>
        <source>For glasses whose red filter is at the right eye</source>
        <translation>उन चश्मों के लिए जिनमें लाल फ़िल्टर दाईं आँख पर है</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>उपकरण</translation>
    </message>
    <message>
        <source>Falcon firmware</source>
        <translation>Falcon फ़र्मवेयर</translation>
    </message>
    <message>
        <source>Keep work for a crash</source>
        <translation>क्रैश के लिए काम रखें</translation>
    </message>
    <message>
        <source>A copy of unsaved work every two seconds, offered after a crash</source>
        <translation>हर दो सेकंड में असहेजे काम की प्रति, क्रैश के बाद प्रस्तुत</translation>
    </message>
    <message>
        <source>Restart no&amp;w</source>
        <translation>अभी पुनः आरंभ करें (&amp;W)</translation>
    </message>
    <message>
        <source>For another language</source>
        <translation>दूसरी भाषा के लिए</translation>
    </message>
    <message>
        <source>End and start again with the same file; asks first if something is not saved</source>
        <translation>बंद करके उसी फ़ाइल के साथ फिर शुरू करें; कुछ सहेजा न हो तो पहले पूछता है</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translation>अभी पुनः आरंभ करें</translation>
    </message>
    <message>
        <source>File with the Falcon&apos;s firmware, or its folder; empty: the usual places. Holds when a Falcon is started next</source>
        <translation>Falcon के फ़र्मवेयर की फ़ाइल या उसका फ़ोल्डर; खाली: सामान्य जगहें। Falcon की अगली शुरुआत से लागू</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>रिकॉर्डिंग</translation>
    </message>
    <message>
        <source>Recordings are</source>
        <translation>रिकॉर्डिंग का रूप</translation>
    </message>
    <message>
        <source>Kind of file of the next recording: a table as text, or HDF5, smaller and with units and surface</source>
        <translation>अगली रिकॉर्डिंग की फ़ाइल का प्रकार: पाठ की तालिका, या HDF5, जो छोटी है और जिसमें इकाइयाँ और सतह हैं</translation>
    </message>
    <message>
        <source>CSV: every program opens it</source>
        <translation>CSV: हर प्रोग्राम खोलता है</translation>
    </message>
    <message>
        <source>HDF5: for Python and MATLAB</source>
        <translation>HDF5: Python और MATLAB के लिए</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>रिकॉर्डिंग का फ़ोल्डर</translation>
    </message>
    <message>
        <source>Where recordings go that are made from now on; empty: relievo in the documents folder</source>
        <translation>अब से बनने वाली रिकॉर्डिंग कहाँ जाएँगी; खाली: दस्तावेज़ों के फ़ोल्डर में relievo</translation>
    </message>
    <message>
        <source>Automatic depth</source>
        <translation>स्वचालित गहराई</translation>
    </message>
    <message>
        <source>Eye separation by the heights that are shown, at the start</source>
        <translation>आरंभ में दिखाई ऊँचाइयों के अनुसार आँखों की दूरी</translation>
    </message>
    <message>
        <source>Angle between the two eyes&apos; directions at the start, without automatic depth</source>
        <translation>आरंभ में दोनों आँखों की दिशाओं के बीच कोण, स्वचालित गहराई के बिना</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>माउस</translation>
    </message>
    <message>
        <source>Left button</source>
        <translation>बायाँ बटन</translation>
    </message>
    <message>
        <source>What it does in the detail view: look turns it, touch presses the hand in (F7)</source>
        <translation>यह विवरण दृश्य में क्या करता है: देखना उसे घुमाता है, स्पर्श हाथ को भीतर दबाता है (F7)</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>देखना</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>स्पर्श</translation>
    </message>
    <message>
        <source>turns the view</source>
        <translation>दृश्य घुमाता है</translation>
    </message>
    <message>
        <source>moves the window</source>
        <translation>विंडो खिसकाता है</translation>
    </message>
    <message>
        <source>zooms</source>
        <translation>पास-दूर करता है</translation>
    </message>
    <message>
        <source>does nothing</source>
        <translation>कुछ नहीं करता</translation>
    </message>
    <message>
        <source>What dragging with this button does in the detail view</source>
        <translation>इस बटन से खींचना विवरण दृश्य में क्या करता है</translation>
    </message>
    <message>
        <source>To look: left</source>
        <translation>देखना: बायाँ</translation>
    </message>
    <message>
        <source>To look: middle</source>
        <translation>देखना: बीच का</translation>
    </message>
    <message>
        <source>To look: right</source>
        <translation>देखना: दायाँ</translation>
    </message>
    <message>
        <source>To touch: middle</source>
        <translation>स्पर्श: बीच का</translation>
    </message>
    <message>
        <source>To touch: right</source>
        <translation>स्पर्श: दायाँ</translation>
    </message>
    <message>
        <source>Wheel away from you</source>
        <translation>पहिया आपसे दूर</translation>
    </message>
    <message>
        <source>Which way the wheel zooms in the detail view</source>
        <translation>विवरण दृश्य में पहिया किस दिशा में पास-दूर करता है</translation>
    </message>
    <message>
        <source>zooms in</source>
        <translation>पास लाता है</translation>
    </message>
    <message>
        <source>zooms out</source>
        <translation>दूर ले जाता है</translation>
    </message>
    <message>
        <source>Kind of stereo</source>
        <translation>स्टीरियो का प्रकार</translation>
    </message>
    <message>
        <source>What stereo starts with: an anaglyph for red and cyan glasses, or pictures for a screen that shows each eye its own</source>
        <translation>स्टीरियो किससे शुरू होता है: लाल-सियान चश्मे के लिए एनाग्लिफ़, या ऐसे पर्दे के लिए चित्र जो हर आँख को अपना दिखाता है</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>अगल-बगल</translation>
    </message>
    <message>
        <source>Over and under</source>
        <translation>ऊपर-नीचे</translation>
    </message>
    <message>
        <source>Interlaced</source>
        <translation>पंक्ति-दर-पंक्ति</translation>
    </message>
    <message>
        <source>Force Dimension&apos;s library</source>
        <translation>Force Dimension की लाइब्रेरी</translation>
    </message>
    <message>
        <source>File libdhd.so.3 or libdrd.so.3 of the maker of omega, delta, sigma and lambda; empty: the usual places. Holds when such a device is looked for next</source>
        <translation>omega, delta, sigma और lambda के निर्माता की फ़ाइल libdhd.so.3 या libdrd.so.3; खाली: सामान्य जगहें। ऐसा उपकरण अगली बार खोजे जाने पर लागू</translation>
    </message>
    <message>
        <source>Plug-ins for devices</source>
        <translation>उपकरणों के प्लगइन</translation>
    </message>
    <message>
        <source>Which plug-ins for haptic devices may run. A plug-in can do all that you can do: allow one only if you know where it is from. A file that changes must be allowed again</source>
        <translation>स्पर्श उपकरणों के कौन-से प्लगइन चल सकते हैं। प्लगइन वह सब कर सकता है जो आप कर सकते हैं: अनुमति तभी दें जब आप जानते हों कि वह कहाँ से है। बदली हुई फ़ाइल को फिर अनुमति चाहिए</translation>
    </message>
    <message>
        <source>Settings found: %1</source>
        <translation>मिली सेटिंग्स: %1</translation>
    </message>
</context>
<context>
    <name>relievo::PrepareDialog</name>
    <message>
        <source>Arrow keys carry the cross, Enter sets a corner, Ctrl+Enter closes the outline</source>
        <translation>तीर कुंजियाँ क्रॉस ले जाती हैं, Enter कोना रखता है, Ctrl+Enter रूपरेखा बंद करता है</translation>
    </message>
    <message>
        <source>Drag the mouse round what is meant, or set corners with Enter; Ctrl+Enter closes.</source>
        <translation>माउस से चारों ओर खींचें, या Enter से कोने रखें; Ctrl+Enter बंद करता है।</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>तैयार करें</translation>
    </message>
    <message>
        <source>Save recipe</source>
        <translation>विधि सहेजें</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>विधियाँ (*.json)</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 सहेजा गया</translation>
    </message>
    <message>
        <source>The command is in the clipboard</source>
        <translation>आदेश क्लिपबोर्ड में है</translation>
    </message>
    <message>
        <source>Undone</source>
        <translation>पूर्ववत किया</translation>
    </message>
    <message>
        <source>Redone</source>
        <translation>फिर किया</translation>
    </message>
</context>
<context>
    <name>relievo::PrepareReport</name>
    <message>
        <source>The chain of scans %1 misses its beginning by %2 mm.</source>
        <translation>स्कैनों %1 की शृंखला अपने आरंभ से %2 mm चूकती है।</translation>
    </message>
    <message>
        <source>%1 % of its points lie within one spacing.</source>
        <translation>इसके %1 % बिंदु एक अंतराल के भीतर हैं।</translation>
    </message>
    <message>
        <source>It may be off by %1 mm.</source>
        <translation>यह %1 mm हटा हो सकता है।</translation>
    </message>
    <message>
        <source>How many points stay</source>
        <translation>कितने बिंदु रहते हैं</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>क्या किया गया</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>समस्या</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>scan, words</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 of %2 points stay.</source>
        <translation>%2 में से %1 बिंदु रहते हैं।</translation>
    </message>
    <message>
        <source>%1 points.</source>
        <translation>%1 बिंदु।</translation>
    </message>
    <message>
        <source>%1 of them are drawn.</source>
        <translation>इनमें से %1 खींचे गए हैं।</translation>
    </message>
    <message>
        <source>Blue lies on the surface of the other scans, red three spacings from it; grey: no other scan is near.</source>
        <translation>नीला दूसरे स्कैनों की सतह पर है, लाल उससे तीन अंतराल दूर; धूसर: पास में कोई दूसरा स्कैन नहीं।</translation>
    </message>
    <message>
        <source>%1 points that the file marks as withheld are left out.</source>
        <translation>%1 बिंदु जिन्हें फ़ाइल रोका हुआ बताती है, छोड़े गए हैं।</translation>
    </message>
</context>
<context>
    <name>relievo::PrepareRunner</name>
    <message>
        <source>No scan is chosen. Tick one in the list of scans.</source>
        <translation>कोई स्कैन नहीं चुना गया। स्कैन सूची में एक पर निशान लगाएँ।</translation>
    </message>
</context>
<context>
    <name>relievo::PrepareViews</name>
    <message>
        <source>Points</source>
        <translation>बिंदु</translation>
    </message>
    <message>
        <source>Drag or arrow keys turn, the right button moves, the wheel or + and - bring it nearer, Home shows all</source>
        <translation>खींचने या तीर कुंजियों से घूमता है, दायाँ बटन खिसकाता है, पहिया या + और - पास लाते हैं, Home सब दिखाता है</translation>
    </message>
    <message>
        <source>Points of the reference</source>
        <translation>संदर्भ के बिंदु</translation>
    </message>
    <message>
        <source>Seen &amp;from:</source>
        <translation>किस ओर से (&amp;F):</translation>
    </message>
    <message>
        <source>From which side the points are seen</source>
        <translation>बिंदु किस ओर से दिखते हैं</translation>
    </message>
    <message>
        <source>Sho&amp;w:</source>
        <translation>दिखाएँ (&amp;W):</translation>
    </message>
    <message>
        <source>Points before and after the steps</source>
        <translation>चरणों से पहले और बाद के बिंदु</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>पहले</translation>
    </message>
    <message>
        <source>Both, red goes</source>
        <translation>दोनों, लाल जाता है</translation>
    </message>
    <message>
        <source>After</source>
        <translation>बाद में</translation>
    </message>
    <message>
        <source>Co&amp;lours:</source>
        <translation>रंग (&amp;L):</translation>
    </message>
    <message>
        <source>What the colours of the points say</source>
        <translation>बिंदुओं के रंग क्या बताते हैं</translation>
    </message>
    <message>
        <source>Their own</source>
        <translation>उनके अपने</translation>
    </message>
    <message>
        <source>One for each scan</source>
        <translation>हर स्कैन का एक</translation>
    </message>
    <message>
        <source>Distance of the scans</source>
        <translation>स्कैनों की दूरी</translation>
    </message>
    <message>
        <source>From the surface of the other scans: blue at 0, red at three spacings, grey where there is none</source>
        <translation>दूसरे स्कैनों की सतह से: 0 पर नीला, तीन अंतराल पर लाल, जहाँ कोई नहीं वहाँ धूसर</translation>
    </message>
</context>
<context>
    <name>relievo::PrepareWorkRow</name>
    <message>
        <source>L&amp;ive</source>
        <translation>साथ-साथ (&amp;I)</translation>
    </message>
    <message>
        <source>Live preview</source>
        <translation>साथ-साथ पूर्वावलोकन</translation>
    </message>
    <message>
        <source>Do the steps anew after each change</source>
        <translation>हर बदलाव के बाद चरण फिर करें</translation>
    </message>
    <message>
        <source>Recom&amp;pute</source>
        <translation>फिर गणना (&amp;P)</translation>
    </message>
    <message>
        <source>Do the steps as they are shown</source>
        <translation>चरण जैसे दिखते हैं वैसे करें</translation>
    </message>
    <message>
        <source>Recompute</source>
        <translation>फिर गणना</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>रोकें (&amp;S)</translation>
    </message>
    <message>
        <source>Stop the work; the picture before stays</source>
        <translation>काम रोकें; पहले की तस्वीर रहती है</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>प्रगति</translation>
    </message>
    <message>
        <source>What is being done</source>
        <translation>क्या हो रहा है</translation>
    </message>
    <message>
        <source>Sa&amp;ve recipe…</source>
        <translation>विधि सहेजें (&amp;V)…</translation>
    </message>
    <message>
        <source>Keep these steps as a file, to do them again</source>
        <translation>ये चरण फ़ाइल में रखें, ताकि फिर किए जा सकें</translation>
    </message>
    <message>
        <source>Cop&amp;y as command</source>
        <translation>आदेश के रूप में कॉपी (&amp;Y)</translation>
    </message>
    <message>
        <source>The command that does the same, once the recipe is saved</source>
        <translation>विधि सहेजने के बाद वही करने वाला आदेश</translation>
    </message>
    <message>
        <source>Write the prepared scan and open it</source>
        <translation>तैयार स्कैन लिखें और खोलें</translation>
    </message>
    <message>
        <source>Recom&amp;pute *</source>
        <translation>फिर गणना (&amp;P) *</translation>
    </message>
</context>
<context>
    <name>relievo::PreparedFileRow</name>
    <message>
        <source>Prepared scan</source>
        <translation>तैयार स्कैन</translation>
    </message>
    <message>
        <source>The file that the prepared scan is written to; the scans stay as they are</source>
        <translation>वह फ़ाइल जिसमें तैयार स्कैन लिखा जाता है; स्कैन जैसे हैं वैसे रहते हैं</translation>
    </message>
    <message>
        <source>It is there already and will be replaced.</source>
        <translation>यह पहले से है और बदल दी जाएगी।</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>चुनें…</translation>
    </message>
    <message>
        <source>Another place or name</source>
        <translation>दूसरी जगह या नाम</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>फ़ाइल चुनें</translation>
    </message>
    <message>
        <source>P&amp;repared scan:</source>
        <translation>तैयार स्कैन (&amp;R):</translation>
    </message>
    <message>
        <source>Scans (*.ply)</source>
        <translation>स्कैन (*.ply)</translation>
    </message>
</context>
<context>
    <name>relievo::ProfileStrip</name>
    <message>
        <source>at %1 mm: height %2 mm</source>
        <translation>%1 mm पर: ऊँचाई %2 mm</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>प्रोफ़ाइल</translation>
    </message>
    <message>
        <source>Press to put the cursor, drag to choose a piece. Arrows move the cursor, with Shift they choose a piece</source>
        <translation>दबाने से सूचक रखें, खींचने से टुकड़ा चुनें। तीर सूचक को हिलाते हैं, Shift के साथ टुकड़ा चुनते हैं</translation>
    </message>
    <message>
        <source>Profile under the views</source>
        <translation>दृश्यों के नीचे प्रोफ़ाइल</translation>
    </message>
    <message>
        <source>Length and depth</source>
        <translation>लंबाई और गहराई</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>सहेजें…</translation>
    </message>
    <message>
        <source>Save profile</source>
        <translation>प्रोफ़ाइल सहेजें</translation>
    </message>
    <message>
        <source>Save the curve as it is shown, or its numbers</source>
        <translation>वक्र जैसा दिखता है, या उसकी संख्याएँ सहेजें</translation>
    </message>
    <message>
        <source>Hide profile</source>
        <translation>प्रोफ़ाइल छिपाएँ</translation>
    </message>
    <message>
        <source>Hide the curve; the Measure menu shows it again</source>
        <translation>वक्र छिपाएँ; माप मेनू उसे फिर दिखाता है</translation>
    </message>
    <message>
        <source>Profile %1: %2</source>
        <translation>प्रोफ़ाइल %1: %2</translation>
    </message>
    <message>
        <source>%1 mm long, %2 mm deep</source>
        <translation>%1 mm लंबा, %2 mm गहरा</translation>
    </message>
    <message>
        <source>%1 to %2 mm: %3 mm long, %4 mm deep, ends differ by %5 mm</source>
        <translation>%1 से %2 mm: %3 mm लंबा, %4 mm गहरा, सिरों में %5 mm का अंतर</translation>
    </message>
</context>
<context>
    <name>relievo::QuestionController</name>
    <message>
        <source>&amp;Keep them</source>
        <translation>उन्हें रखें (&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Leave them out</source>
        <translation>उन्हें छोड़ दें (&amp;L)</translation>
    </message>
    <message>
        <source>One of %1 points lies %2 % of the box away from all others.</source>
        <translation>%1 में से एक बिंदु बाकी सबसे घेरे के %2 % जितना दूर है।</translation>
    </message>
    <message>
        <source>%1 of %2 points lie %3 % of the box away from all others.</source>
        <translation>%2 में से %1 बिंदु बाकी सबसे घेरे के %3 % जितने दूर हैं।</translation>
    </message>
    <message>
        <source>Kept, and so most of the map is empty.</source>
        <translation>रखे गए हैं, इसलिए मानचित्र का अधिकांश भाग खाली है।</translation>
    </message>
    <message>
        <source>Left out.</source>
        <translation>छोड़ दिए गए।</translation>
    </message>
    <message>
        <source>%1 of %2 points lie together, %3 % of the box away from all others.</source>
        <translation>%2 में से %1 बिंदु एक साथ, बाकी सबसे घेरे के %3 % जितने दूर हैं।</translation>
    </message>
    <message>
        <source>Kept, as they may belong to the object.</source>
        <translation>रखे गए हैं, क्योंकि वे वस्तु के हो सकते हैं।</translation>
    </message>
    <message>
        <source>%1 of %2 heights are %3, which often stands for a missing one. They were left out.</source>
        <translation>%2 में से %1 ऊँचाइयाँ %3 हैं, जो अक्सर अनुपस्थित ऊँचाई के लिए लिखा जाता है। वे छोड़ दी गई हैं।</translation>
    </message>
    <message>
        <source>&amp;Take as missing</source>
        <translation>अनुपस्थित मानें (&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Keep as heights</source>
        <translation>ऊँचाई मानें (&amp;K)</translation>
    </message>
    <message>
        <source>How this object stands is not certain. From where shall it be seen?</source>
        <translation>यह वस्तु कैसे खड़ी है, यह निश्चित नहीं है। इसे किधर से देखा जाए?</translation>
    </message>
    <message>
        <source>in %1 %2</source>
        <translation>%1 में %2</translation>
    </message>
    <message>
        <source>%1 × %2 × %3</source>
        <translation>%1 × %2 × %3</translation>
    </message>
    <message>
        <source>%1: %2. Which unit?</source>
        <translation>%1: %2। कौन-सी इकाई?</translation>
    </message>
    <message>
        <source>The points carry no unit. %1 – %2. The coordinates are those of a map projection; shown as %3 until you say. (E103)</source>
        <translation>बिंदुओं की कोई इकाई नहीं है। %1 – %2। निर्देशांक किसी मानचित्र प्रक्षेप के हैं; जब तक आप न बताएँ, %3 माने गए हैं। (E103)</translation>
    </message>
    <message>
        <source>The points carry no unit. %1 – %2. Most likely %3. Shown as millimetres until you say. (E103)</source>
        <translation>बिंदुओं में कोई इकाई नहीं है। %1 – %2। सबसे संभव %3। आपके बताने तक मिलीमीटर माने गए। (E103)</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) that this project names were not read. They stay named in it, and are offered for no package and no figure.</source>
        <translation>
            <numerusform>%n फ़ाइल, जिसका नाम यह प्रोजेक्ट लेता है, नहीं पढ़ी गई। उसका नाम इसमें बना रहता है, और वह किसी पैकेज या चित्र के लिए नहीं दी जाती।</numerusform>
            <numerusform>%n फ़ाइलें, जिनके नाम यह प्रोजेक्ट लेता है, नहीं पढ़ी गईं। उनके नाम इसमें बने रहते हैं, और वे किसी पैकेज या चित्र के लिए नहीं दी जातीं।</numerusform>
        </translation>
    </message>
    <message>
        <source>This picture of heights does not say how large it is. Shown with pixels of %1 mm and steps of %2 mm: %3.</source>
        <translation>ऊँचाइयों का यह चित्र नहीं बताता कि वह कितना बड़ा है। %1 mm के पिक्सेल और %2 mm के चरणों के साथ दिखाया गया: %3।</translation>
    </message>
    <message>
        <source>The steps are a guess: with 1 mm it would be higher than it is long.</source>
        <translation>चरण एक अनुमान हैं: 1 mm से यह लंबाई से अधिक ऊँचा होता।</translation>
    </message>
    <message>
        <source>Both are a guess.</source>
        <translation>दोनों अनुमान हैं।</translation>
    </message>
    <message>
        <source>&amp;Say how large…</source>
        <translation>आकार बताएँ… (&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Keep it so</source>
        <translation>ऐसे ही रखें (&amp;K)</translation>
    </message>
</context>
<context>
    <name>relievo::RasterScaleDialog</name>
    <message>
        <source>Distance of the pixels</source>
        <translation>पिक्सेलों की दूरी</translation>
    </message>
    <message>
        <source>From one sample to the next, on the object</source>
        <translation>वस्तु पर, एक नमूने से अगले तक</translation>
    </message>
    <message>
        <source>Height of a step</source>
        <translation>एक चरण की ऊँचाई</translation>
    </message>
    <message>
        <source>By how much the surface rises where the value grows by 1</source>
        <translation>जहाँ मान 1 बढ़ता है वहाँ सतह कितनी उठती है</translation>
    </message>
    <message>
        <source>Value on the base plane</source>
        <translation>आधार तल पर मान</translation>
    </message>
    <message>
        <source>Samples with this value lie at height 0, lower ones below it</source>
        <translation>इस मान वाले नमूने ऊँचाई 0 पर हैं, उससे कम नीचे</translation>
    </message>
    <message>
        <source>&amp;Larger values lie deeper</source>
        <translation>बड़े मान गहरे हैं (&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Base plane at the value</source>
        <translation>आधार तल इस मान पर (&amp;B)</translation>
    </message>
    <message>
        <source>Size of the samples</source>
        <translation>नमूनों का आकार</translation>
    </message>
    <message>
        <source>As in pictures of distances from a camera</source>
        <translation>जैसे कैमरे से दूरियों के चित्रों में</translation>
    </message>
    <message>
        <source>Otherwise it is the lowest sample</source>
        <translation>अन्यथा सबसे नीचा नमूना</translation>
    </message>
    <message>
        <source>Size that follows</source>
        <translation>इससे बनने वाला आकार</translation>
    </message>
    <message>
        <source>&amp;Distance of the pixels</source>
        <translation>पिक्सेलों की दूरी (&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Height of a step of 1</source>
        <translation>1 के चरण की ऊँचाई (&amp;H)</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>आकार</translation>
    </message>
</context>
<context>
    <name>relievo::RecordingControl</name>
    <message>
        <source>Recording to %1</source>
        <translation>%1 में रिकॉर्डिंग</translation>
    </message>
    <message>
        <source>The last %1 before the fault are kept: %2</source>
        <translation>गड़बड़ी से पहले के %1 रखे गए हैं: %2</translation>
    </message>
    <message>
        <source>The recording has ended early.</source>
        <translation>रिकॉर्डिंग समय से पहले समाप्त हुई।</translation>
    </message>
    <message>
        <source>Recording saved: %1, %2 samples in %3</source>
        <translation>रिकॉर्डिंग सहेजी गई: %1, %3 में %2 नमूने</translation>
    </message>
    <message>
        <source>Note at %1 s: %2</source>
        <translation>%1 s पर टिप्पणी: %2</translation>
    </message>
    <message>
        <source>The recording had ended before the note &quot;%1&quot; was added. The note is in no file.</source>
        <translation>टिप्पणी “%1” जुड़ने से पहले ही रिकॉर्डिंग समाप्त हो गई थी। टिप्पणी किसी फ़ाइल में नहीं है।</translation>
    </message>
</context>
<context>
    <name>relievo::RecordingsEnd</name>
    <message>
        <source>Recording saved: %1</source>
        <translation>रिकॉर्डिंग सहेजी गई: %1</translation>
    </message>
</context>
<context>
    <name>relievo::ReferenceView</name>
    <message>
        <source>Draw window</source>
        <translation>विंडो बनाएँ</translation>
    </message>
    <message>
        <source>Move window</source>
        <translation>विंडो खिसकाएँ</translation>
    </message>
    <message>
        <source>Resize window</source>
        <translation>विंडो का आकार बदलें</translation>
    </message>
    <message>
        <source>Drawing a window from x %1, y %2. Arrows carry the other corner, Enter ends, Escape returns</source>
        <translation>x %1, y %2 से विंडो बन रही है। तीर दूसरा कोना ले जाते हैं, Enter पूरा करता है, Escape लौटाता है</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>अवलोकन</translation>
    </message>
    <message>
        <source>The whole object. The pink window is what the detail view shows: drag inside it to move it, drag its edges to resize it, drag outside to draw a new one. The wheel changes the resolution. Keys: arrows, Shift+arrows, + and -; Space, arrows and Enter draw a window.</source>
        <translation>पूरी वस्तु। गुलाबी विंडो वही है जो विवरण दृश्य दिखाता है: भीतर खींचने से खिसकती है, किनारे खींचने से आकार बदलता है, बाहर खींचने से नई बनती है। पहिया रिज़ॉल्यूशन बदलता है। कुंजियाँ: तीर, Shift+तीर, + और -; Space, तीर और Enter विंडो बनाते हैं।</translation>
    </message>
    <message>
        <source>Resolution %1 of %2, window %3 wide, lower left corner at x %4, y %5</source>
        <translation>रिज़ॉल्यूशन %2 में से %1, विंडो %3 चौड़ी, निचला बायाँ कोना x %4, y %5 पर</translation>
    </message>
</context>
<context>
    <name>relievo::RegionEditor</name>
    <message>
        <source>Larger window</source>
        <translation>बड़ी खिड़की</translation>
    </message>
    <message>
        <source>Smaller window</source>
        <translation>छोटी खिड़की</translation>
    </message>
    <message>
        <source>Whole object</source>
        <translation>पूरी वस्तु</translation>
    </message>
    <message>
        <source>Move window</source>
        <translation>विंडो खिसकाएँ</translation>
    </message>
    <message>
        <source>Choose window</source>
        <translation>विंडो चुनें</translation>
    </message>
    <message>
        <source>Vertical exaggeration</source>
        <translation>ऊर्ध्व अतिरंजन</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>पास लाएँ</translation>
    </message>
    <message>
        <source>Resolution %1 → %2</source>
        <translation>रिज़ॉल्यूशन %1 → %2</translation>
    </message>
</context>
<context>
    <name>relievo::RegionPanel</name>
    <message>
        <source>Left edge of the pink window</source>
        <translation>गुलाबी विंडो का बायाँ किनारा</translation>
    </message>
    <message>
        <source>Left edge of the window</source>
        <translation>विंडो का बायाँ किनारा</translation>
    </message>
    <message>
        <source>Lower edge of the pink window</source>
        <translation>गुलाबी विंडो का निचला किनारा</translation>
    </message>
    <message>
        <source>Lower edge of the window</source>
        <translation>विंडो का निचला किनारा</translation>
    </message>
    <message>
        <source>Si&amp;de</source>
        <translation>भुजा (&amp;D)</translation>
    </message>
    <message>
        <source>Width and height of the pink window</source>
        <translation>गुलाबी विंडो की चौड़ाई और ऊँचाई</translation>
    </message>
    <message>
        <source>Heights are multiplied by this; 1 is true to scale</source>
        <translation>ऊँचाइयाँ इससे गुणा होती हैं; 1 वास्तविक पैमाना है</translation>
    </message>
    <message>
        <source>Heights are multiplied by this; the middle is true to scale</source>
        <translation>ऊँचाइयाँ इससे गुणा होती हैं; बीच में वास्तविक पैमाना है</translation>
    </message>
    <message>
        <source>Hand scale</source>
        <translation>हाथ का पैमाना</translation>
    </message>
    <message>
        <source>Vertical exaggeration</source>
        <translation>ऊर्ध्व अतिरंजन</translation>
    </message>
    <message>
        <source>Exaggeratio&amp;n</source>
        <translation>अतिरंजन (&amp;N)</translation>
    </message>
    <message>
        <source>Hand scale 1 : %1</source>
        <translation>हाथ का पैमाना 1 : %1</translation>
    </message>
    <message>
        <source>%1/%2 (level 0)</source>
        <translation>%1/%2 (स्तर 0)</translation>
    </message>
    <message>
        <source>%1/%2 (level %3, σ %4)</source>
        <translation>%1/%2 (स्तर %3, σ %4)</translation>
    </message>
    <message>
        <source>Reso&amp;lution</source>
        <translation>रिज़ॉल्यूशन (&amp;L)</translation>
    </message>
    <message>
        <source>Which level of the pyramid feeds the window</source>
        <translation>विंडो में पिरामिड का कौन-सा स्तर है</translation>
    </message>
</context>
<context>
    <name>relievo::ReplayControl</name>
    <message>
        <source>Paused, %1</source>
        <translation>रुका हुआ, %1</translation>
    </message>
    <message numerus="yes">
        <source>The recording does not say where %n window(s) lay; they are shown around what was touched.</source>
        <translation>
            <numerusform>रिकॉर्डिंग नहीं बताती कि %n विंडो कहाँ थी; वह छुई जगह के आसपास दिखाई गई है।</numerusform>
            <numerusform>रिकॉर्डिंग नहीं बताती कि %n विंडो कहाँ थीं; वे छुई जगह के आसपास दिखाई गई हैं।</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>रद्द किया गया। कुछ नहीं बदला।</translation>
    </message>
    <message>
        <source>%1 does not say what was touched. Open that file first.</source>
        <translation>%1 नहीं बताती कि क्या छुआ गया था। पहले वह फ़ाइल खोलें।</translation>
    </message>
    <message>
        <source>%1 was recorded on %2, which is not open.</source>
        <translation>%1, %2 पर रिकॉर्ड हुई, जो खुली नहीं है।</translation>
    </message>
    <message>
        <source>%1 was recorded on %2, not on %3.</source>
        <translation>%1, %2 पर रिकॉर्ड हुई, %3 पर नहीं।</translation>
    </message>
    <message>
        <source>%1 was recorded on another view of %2 or with another unit.</source>
        <translation>%1, %2 के दूसरे दृश्य पर या दूसरी इकाई में रिकॉर्ड हुई।</translation>
    </message>
    <message>
        <source>%1 does not say what it was recorded on; it is shown on the open map.</source>
        <translation>%1 नहीं बताती कि किस पर रिकॉर्ड हुई; उसे खुले मानचित्र पर दिखाया गया है।</translation>
    </message>
    <message>
        <source>Replay of %1, %2 s. Forces are off. Space plays.</source>
        <translation>%1 का पुनर्प्रदर्शन, %2 s। बल बंद हैं। Space चलाता है।</translation>
    </message>
    <message>
        <source>Replay closed</source>
        <translation>पुनर्प्रदर्शन बंद हुआ</translation>
    </message>
    <message>
        <source>No event after this place</source>
        <translation>इस जगह के बाद कोई घटना नहीं</translation>
    </message>
    <message>
        <source>No event before this place</source>
        <translation>इस जगह से पहले कोई घटना नहीं</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s: %2</translation>
    </message>
    <message>
        <source>Playing</source>
        <translation>चल रहा है</translation>
    </message>
</context>
<context>
    <name>relievo::ReplayController</name>
    <message>
        <source>The next recording is %1</source>
        <translation>अगली रिकॉर्डिंग %1 होगी</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>रिकॉर्डिंग का फ़ोल्डर</translation>
    </message>
    <message>
        <source>Recordings go to %1</source>
        <translation>रिकॉर्डिंग %1 में जाएँगी</translation>
    </message>
    <message>
        <source>Recordings are kept in %1.</source>
        <translation>रिकॉर्डिंग %1 में रखी जाती हैं।</translation>
    </message>
    <message>
        <source>Another &amp;folder…</source>
        <translation>दूसरा फ़ोल्डर… (&amp;F)</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>पुनर्प्रदर्शन</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.h5 *.hdf5)</source>
        <translation>रिकॉर्डिंग (*.csv *.h5 *.hdf5)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>सभी फ़ाइलें (*)</translation>
    </message>
    <message>
        <source>A recording is running. Nothing was opened. Stop it first (Ctrl+R).</source>
        <translation>रिकॉर्डिंग चल रही है। कुछ नहीं खोला गया। पहले उसे रोकें (Ctrl+R)।</translation>
    </message>
    <message>
        <source>%1 Nothing was changed.</source>
        <translation>%1 कुछ नहीं बदला।</translation>
    </message>
    <message>
        <source>&amp;Open its input</source>
        <translation>उसका स्रोत खोलें (&amp;O)</translation>
    </message>
</context>
<context>
    <name>relievo::ReplayPanel</name>
    <message>
        <source>Play</source>
        <translation>चलाएँ</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>चलाएँ या रोकें (Space)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>बंद करें</translation>
    </message>
    <message>
        <source>End the replay (Esc)</source>
        <translation>पुनर्प्रदर्शन समाप्त करें (Esc)</translation>
    </message>
    <message>
        <source>Height of hand and proxy in the recording</source>
        <translation>रिकॉर्डिंग में हाथ और प्रॉक्सी की ऊँचाई</translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation>z (mm)</translation>
    </message>
    <message>
        <source>Force in the recording</source>
        <translation>रिकॉर्डिंग में बल</translation>
    </message>
    <message>
        <source>force (N)</source>
        <translation>बल (N)</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>पुनर्प्रदर्शन</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>रोकें</translation>
    </message>
    <message>
        <source>Place in the recording</source>
        <translation>रिकॉर्डिंग में जगह</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>रिकॉर्डिंग में समय</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>गति</translation>
    </message>
    <message>
        <source>How fast the recording is shown</source>
        <translation>रिकॉर्डिंग कितनी तेज़ दिखती है</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%2 s में से %1</translation>
    </message>
    <message>
        <source>Drag through the recording; left and right by 0.1 s, Page keys by 1 s, up and down by events</source>
        <translation>रिकॉर्डिंग में खींचें; बाएँ-दाएँ 0.1 s, Page कुंजियाँ 1 s, ऊपर-नीचे घटनाएँ</translation>
    </message>
    <message>
        <source>◂ Event</source>
        <translation>◂ घटना</translation>
    </message>
    <message>
        <source>Event before</source>
        <translation>पिछली घटना</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>ऊपर तीर</translation>
    </message>
    <message>
        <source>Event ▸</source>
        <translation>घटना ▸</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>अगली घटना</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>नीचे तीर</translation>
    </message>
    <message>
        <source>◂ Sample</source>
        <translation>◂ नमूना</translation>
    </message>
    <message>
        <source>Sample before</source>
        <translation>पिछला नमूना</translation>
    </message>
    <message>
        <source>Shift+Left</source>
        <translation>Shift+बायाँ तीर</translation>
    </message>
    <message>
        <source>Sample ▸</source>
        <translation>नमूना ▸</translation>
    </message>
    <message>
        <source>Next sample</source>
        <translation>अगला नमूना</translation>
    </message>
    <message>
        <source>Shift+Right</source>
        <translation>Shift+दायाँ तीर</translation>
    </message>
    <message>
        <source>Here in the recording</source>
        <translation>रिकॉर्डिंग में यहाँ</translation>
    </message>
    <message>
        <source>   |   since %1 s: %2</source>
        <translation>   |   %1 s से: %2</translation>
    </message>
    <message>
        <source>HIP z %1 mm   proxy z %2 mm   force %3 N</source>
        <translation>HIP z %1 mm   प्रॉक्सी z %2 mm   बल %3 N</translation>
    </message>
</context>
<context>
    <name>relievo::SaveController</name>
    <message>
        <source>Unsaved work</source>
        <translation>सहेजा नहीं गया काम</translation>
    </message>
    <message>
        <source>Save it as a project?</source>
        <translation>क्या इसे परियोजना के रूप में सहेजें?</translation>
    </message>
    <message>
        <source>relievo could not be started again. Nothing was changed. Close it and start it yourself.</source>
        <translation>relievo दोबारा शुरू नहीं हो सका। कुछ नहीं बदला गया। इसे बंद करके स्वयं शुरू करें।</translation>
    </message>
    <message>
        <source>relievo closes when the package is written</source>
        <translation>पैकेज लिखे जाने पर relievo बंद होगा</translation>
    </message>
    <message>
        <source>relievo closes when the map is written</source>
        <translation>मानचित्र लिखे जाने पर relievo बंद होगा</translation>
    </message>
    <message>
        <source>relievo closes when the video is saved; Escape stops both</source>
        <translation>वीडियो सहेजे जाने पर relievo बंद होगा; Escape दोनों को रोकता है</translation>
    </message>
    <message>
        <source>relievo closes when the picture is saved</source>
        <translation>चित्र सहेजे जाने पर relievo बंद होगा</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>परियोजना सहेजें</translation>
    </message>
    <message>
        <source>Projects (*.relievo.json)</source>
        <translation>परियोजनाएँ (*.relievo.json)</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 सहेजी गई</translation>
    </message>
    <message>
        <source>%1[*] – relievo</source>
        <translation>%1[*] – relievo</translation>
    </message>
    <message>
        <source>Work on %1 is in no file yet: bookmarks, measurements, camera paths or settings.</source>
        <translation>%1 पर किया काम अभी किसी फ़ाइल में नहीं है: बुकमार्क, माप, कैमरा पथ या सेटिंग।</translation>
    </message>
</context>
<context>
    <name>relievo::ScanList</name>
    <message>
        <source>Scans</source>
        <translation>स्कैन</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>स्कैन</translation>
    </message>
    <message>
        <source>Lies</source>
        <translation>स्थिति</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>जोड़ें (&amp;A)…</translation>
    </message>
    <message>
        <source>Further scans of the same object</source>
        <translation>उसी वस्तु के और स्कैन</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>हटाएँ</translation>
    </message>
    <message>
        <source>Take the chosen scan off the list</source>
        <translation>चुना स्कैन सूची से हटाएँ</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>संदर्भ</translation>
    </message>
    <message>
        <source>The chosen scan stays where it is; the others are laid on it</source>
        <translation>चुना स्कैन जहाँ है वहीं रहता है; बाकी उस पर रखे जाते हैं</translation>
    </message>
    <message>
        <source>Pic&amp;k pairs…</source>
        <translation>जोड़े चुनें (&amp;K)…</translation>
    </message>
    <message>
        <source>Show the same three places on the chosen scan and on the reference</source>
        <translation>चुने स्कैन और संदर्भ पर वही तीन जगहें दिखाएँ</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>वापस लें</translation>
    </message>
    <message>
        <source>Forget the place picked last</source>
        <translation>अंतिम चुनी जगह भूलें</translation>
    </message>
    <message>
        <source>Remove pair</source>
        <translation>जोड़ा हटाएँ</translation>
    </message>
    <message>
        <source>Forget the chosen pair, such as the one that fits worst (Delete)</source>
        <translation>चुना हुआ जोड़ा भूलें, जैसे वह जो सबसे कम मेल खाता है (Delete)</translation>
    </message>
    <message>
        <source>Picked pairs</source>
        <translation>चुने हुए जोड़े</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>जोड़ा</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>त्रुटि</translation>
    </message>
    <message>
        <source>How far apart each pair&apos;s places are left where all pairs fit best; from three on</source>
        <translation>सभी जोड़े जहाँ सबसे अच्छे मेल खाते हैं वहाँ हर जोड़े की जगहें कितनी दूर रह जाती हैं; तीन जोड़ों से</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>अलग करें</translation>
    </message>
    <message>
        <source>Each of the file&apos;s scans for itself, to leave some out or align them</source>
        <translation>फ़ाइल का हर स्कैन अलग, ताकि कुछ छोड़े या संरेखित किए जा सकें</translation>
    </message>
    <message>
        <source>With withheld points</source>
        <translation>रोके गए बिंदुओं सहित</translation>
    </message>
    <message>
        <source>Points of the chosen scan that its file marks as not to be used</source>
        <translation>चुने स्कैन के वे बिंदु जिन्हें फ़ाइल काम में न लेने को चिह्नित करती है</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>number, scan</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>संदर्भ</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>as stored</source>
        <translation>जैसा सहेजा गया</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>अभी नहीं</translation>
    </message>
    <message>
        <source>Pairs are pic&amp;ked</source>
        <translation>जोड़े चुन लिए (&amp;K)</translation>
    </message>
    <message>
        <source>Pairs are picked</source>
        <translation>जोड़े चुन लिए</translation>
    </message>
    <message>
        <source>Pick pairs</source>
        <translation>जोड़े चुनें</translation>
    </message>
    <message>
        <source>Pair %1</source>
        <translation>जोड़ा %1</translation>
    </message>
    <message>
        <source>%1 mm, worst</source>
        <translation>%1 mm, सबसे अधिक</translation>
    </message>
    <message>
        <source>Add scans</source>
        <translation>स्कैन जोड़ें</translation>
    </message>
</context>
<context>
    <name>relievo::ScanView</name>
    <message>
        <source>Make relief from here</source>
        <translation>यहाँ से उभार बनाएँ</translation>
    </message>
    <message>
        <source>As the relief</source>
        <translation>उभार जैसा</translation>
    </message>
    <message>
        <source>Make the relief anew as the scan is looked at now (Enter)</source>
        <translation>अभी जैसा स्कैन देखा जा रहा है वैसा उभार फिर बनाएँ (Enter)</translation>
    </message>
    <message>
        <source>Look at the scan from where the relief is seen</source>
        <translation>स्कैन को वहाँ से देखें जहाँ से उभार दिखता है</translation>
    </message>
    <message>
        <source>Scan in 3-D</source>
        <translation>स्कैन 3-D में</translation>
    </message>
    <message>
        <source>The scan behind the relief. Drag with the left button or use the arrows to turn it, the right button moves it, the wheel or + and - bring it nearer, Home shows all of it. Enter makes the relief from here. The box is the window, the arrow shows along which direction the relief is seen.</source>
        <translation>उभार के पीछे का स्कैन। बाएँ बटन से खींचना या तीर कुंजियाँ उसे घुमाती हैं, दायाँ बटन खिसकाता है, पहिया या + और - पास लाते हैं, Home पूरा दिखाता है। Enter यहाँ से उभार बनाता है। डिब्बा विंडो है, तीर दिखाता है कि उभार किस दिशा में देखा जाता है।</translation>
    </message>
    <message>
        <source>The scan is being prepared for the view…</source>
        <translation>स्कैन दृश्य के लिए तैयार किया जा रहा है…</translation>
    </message>
    <message>
        <source>Points: %1 of %2</source>
        <translation>बिंदु: %2 में से %1</translation>
    </message>
    <message>
        <source>Triangles: %1</source>
        <translation>त्रिभुज: %1</translation>
    </message>
    <message>
        <source>Seen as the relief is</source>
        <translation>उभार जैसा ही दिखता है</translation>
    </message>
    <message>
        <source>Turned by %1° from where the relief is seen</source>
        <translation>उभार की दिशा से %1° घुमा हुआ</translation>
    </message>
</context>
<context>
    <name>relievo::ScopeDialog</name>
    <message>
        <source>Force and height against time</source>
        <translation>समय के साथ बल और ऊँचाई</translation>
    </message>
    <message>
        <source>Values at the cursor</source>
        <translation>सूचक पर मान</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>ठहराएँ (&amp;P)</translation>
    </message>
    <message>
        <source>Hold the plots still</source>
        <translation>आलेख स्थिर रखें</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>पास लाएँ (&amp;I)</translation>
    </message>
    <message>
        <source>Show a shorter time (plus, wheel)</source>
        <translation>कम समय दिखाएँ (प्लस, पहिया)</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>दूर करें (&amp;O)</translation>
    </message>
    <message>
        <source>Show a longer time (minus, wheel)</source>
        <translation>अधिक समय दिखाएँ (माइनस, पहिया)</translation>
    </message>
    <message>
        <source>&amp;SVG…</source>
        <translation>&amp;SVG…</translation>
    </message>
    <message>
        <source>Save what is shown as a drawing</source>
        <translation>जो दिखता है उसे रेखाचित्र के रूप में सहेजें</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>रेखाचित्र (*.svg)</translation>
    </message>
    <message>
        <source>&amp;CSV…</source>
        <translation>&amp;CSV…</translation>
    </message>
    <message>
        <source>Save what is shown as a table</source>
        <translation>जो दिखता है उसे तालिका के रूप में सहेजें</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>तालिकाएँ (*.csv)</translation>
    </message>
    <message>
        <source>Save the plots</source>
        <translation>आलेख सहेजें</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>सहेजा गया: %1</translation>
    </message>
</context>
<context>
    <name>relievo::ScopeView</name>
    <message>
        <source>Height of hand and proxy, and force</source>
        <translation>हाथ और प्रॉक्सी की ऊँचाई, और बल</translation>
    </message>
    <message>
        <source>Left and Right move the cursor, plus and minus zoom.</source>
        <translation>बायाँ और दायाँ तीर सूचक चलाते हैं, प्लस और माइनस पास लाते और दूर करते हैं।</translation>
    </message>
    <message>
        <source>Nothing measured yet.</source>
        <translation>अभी कुछ नहीं मापा गया।</translation>
    </message>
    <message>
        <source>At %1 s: HIP %2 mm, proxy %3 mm, force %4 N</source>
        <translation>%1 s पर: HIP %2 mm, प्रॉक्सी %3 mm, बल %4 N</translation>
    </message>
</context>
<context>
    <name>relievo::SetupHomingBox</name>
    <message>
        <source>Homing</source>
        <translation>आरंभ स्थिति</translation>
    </message>
    <message>
        <source>Top arm</source>
        <translation>ऊपरी भुजा</translation>
    </message>
    <message>
        <source>Right arm</source>
        <translation>दाईं भुजा</translation>
    </message>
    <message>
        <source>Left arm</source>
        <translation>बाईं भुजा</translation>
    </message>
    <message>
        <source>Place of the hand</source>
        <translation>हाथ का स्थान</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>हाथ</translation>
    </message>
    <message>
        <source>✓ found</source>
        <translation>✓ मिला</translation>
    </message>
    <message>
        <source>– missing</source>
        <translation>– नहीं मिला</translation>
    </message>
    <message>
        <source>%1 right, %2 up, %3 out, in millimetres; %4 answers per second</source>
        <translation>दाएँ %1, ऊपर %2, बाहर %3, मिलीमीटर में; प्रति सेकंड %4 उत्तर</translation>
    </message>
    <message>
        <source>not known before homing</source>
        <translation>आरंभ स्थिति से पहले ज्ञात नहीं</translation>
    </message>
</context>
<context>
    <name>relievo::SetupStartBox</name>
    <message>
        <source>Start</source>
        <translation>शुरू</translation>
    </message>
    <message>
        <source>&amp;Retry</source>
        <translation>फिर कोशिश (&amp;R)</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>फिर कोशिश</translation>
    </message>
    <message>
        <source>&amp;Firmware file…</source>
        <translation>फ़र्मवेयर फ़ाइल (&amp;F)…</translation>
    </message>
    <message>
        <source>Firmware file</source>
        <translation>फ़र्मवेयर फ़ाइल</translation>
    </message>
    <message>
        <source>&amp;Copy rule</source>
        <translation>नियम की प्रति (&amp;C)</translation>
    </message>
    <message>
        <source>Copy rule</source>
        <translation>नियम की प्रति</translation>
    </message>
    <message>
        <source>Firmware file in use</source>
        <translation>उपयोग में फ़र्मवेयर फ़ाइल</translation>
    </message>
    <message>
        <source>Firmware loaded</source>
        <translation>फ़र्मवेयर लोड हुआ</translation>
    </message>
    <message>
        <source>not loaded yet</source>
        <translation>अभी लोड नहीं</translation>
    </message>
    <message>
        <source>Rule that gives access</source>
        <translation>पहुँच देने वाला नियम</translation>
    </message>
    <message>
        <source># As an administrator, write this into /etc/udev/rules.d/60-relievo-falcon.rules, then replug:
</source>
        <translation># प्रशासक के रूप में इसे /etc/udev/rules.d/60-relievo-falcon.rules में लिखें, फिर दोबारा जोड़ें:
</translation>
    </message>
    <message>
        <source>attempt %1 of %2, %p %</source>
        <translation>प्रयास %2 में से %1, %p %</translation>
    </message>
    <message>
        <source>was running already</source>
        <translation>पहले से चल रहा था</translation>
    </message>
    <message>
        <source>Firmware: %1, %2</source>
        <translation>फ़र्मवेयर: %1, %2</translation>
    </message>
    <message>
        <source>Firmware: %1, accepted by you</source>
        <translation>फ़र्मवेयर: %1, आपने स्वीकार किया</translation>
    </message>
    <message>
        <source>Firmware: no file found yet</source>
        <translation>फ़र्मवेयर: अभी कोई फ़ाइल नहीं मिली</translation>
    </message>
    <message>
        <source>Firmware: %1 cannot be used</source>
        <translation>फ़र्मवेयर: %1 उपयोग योग्य नहीं</translation>
    </message>
</context>
<context>
    <name>relievo::SidePanels</name>
    <message>
        <source>Panels</source>
        <translation>पटल</translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation>%1 दिखाएँ या छिपाएँ</translation>
    </message>
    <message>
        <source>%1 panel</source>
        <translation>%1 पटल</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>मुड़ा हुआ</translation>
    </message>
    <message>
        <source>open</source>
        <translation>खुला</translation>
    </message>
</context>
<context>
    <name>relievo::SoundControl</name>
    <message>
        <source>the sound server does not answer</source>
        <translation>ध्वनि सर्वर उत्तर नहीं देता</translation>
    </message>
    <message>
        <source>There is no sound: %1. Touch goes on without it. Switch the sounds off and on to try again.</source>
        <translation>ध्वनि नहीं है: %1। स्पर्श उसके बिना चलता रहता है। फिर कोशिश करने के लिए ध्वनियाँ बंद करके चालू करें।</translation>
    </message>
    <message>
        <source>Sounds of touch at %1 percent.</source>
        <translation>स्पर्श की ध्वनियाँ %1 प्रतिशत पर।</translation>
    </message>
    <message>
        <source>Sounds of touch on.</source>
        <translation>स्पर्श की ध्वनियाँ चालू।</translation>
    </message>
    <message>
        <source>Sounds of touch off.</source>
        <translation>स्पर्श की ध्वनियाँ बंद।</translation>
    </message>
</context>
<context>
    <name>relievo::SoundRows</name>
    <message>
        <source>Sounds of touch</source>
        <translation>स्पर्श की ध्वनियाँ</translation>
    </message>
    <message>
        <source>Volume of the sounds in percent</source>
        <translation>ध्वनियों की मात्रा प्रतिशत में</translation>
    </message>
    <message>
        <source>Hear what the hand meets, while it touches (Ctrl+Alt+A).</source>
        <translation>छूते समय सुनें कि हाथ किससे मिलता है (Ctrl+Alt+A)।</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Of the sounds of touch; speech has a volume of its own.</source>
        <translation>स्पर्श की ध्वनियों की; बोली की अपनी अलग मात्रा है।</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>आवाज़ का स्तर</translation>
    </message>
    <message>
        <source>Felt patterns</source>
        <translation>स्पर्श संकेत</translation>
    </message>
    <message>
        <source>Taps of the grip: one is yes, two not measured, three the edge. Only while forces are on.</source>
        <translation>हैंडल की थपकियाँ: एक हाँ, दो मापा नहीं गया, तीन किनारा। केवल जब बल चालू हों।</translation>
    </message>
</context>
<context>
    <name>relievo::StartPage</name>
    <message>
        <source>Acceptance relief: dome, step, ridge, grating</source>
        <translation>स्वीकृति उभार: गुंबद, सीढ़ी, धार, जाली</translation>
    </message>
    <message>
        <source>Coin, 24 mm across</source>
        <translation>सिक्का, 24 mm चौड़ा</translation>
    </message>
    <message>
        <source>Carved panel with undercuts</source>
        <translation>नीचे कटाव वाला नक्काशीदार फलक</translation>
    </message>
    <message>
        <source>Ruin, 400 m across</source>
        <translation>खंडहर, 400 m चौड़ा</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>शुरू</translation>
    </message>
    <message>
        <source>Open a scan to see and touch it</source>
        <translation>देखने और छूने के लिए स्कैन खोलें</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>खोलें (&amp;O)…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>खोलें</translation>
    </message>
    <message>
        <source>Open a scan (Ctrl+O)</source>
        <translation>स्कैन खोलें (Ctrl+O)</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>नमूने</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>हाल के</translation>
    </message>
    <message>
        <source>Point clouds and meshes (%1), height maps (TIFF, PNG, ASCII grid), projects and figures. You can also drop a file on this window.</source>
        <translation>बिंदु-मेघ और जाल (%1), ऊँचाई मानचित्र (TIFF, PNG, ASCII ग्रिड), परियोजनाएँ और चित्र। फ़ाइल को इस खिड़की पर भी छोड़ा जा सकता है।</translation>
    </message>
</context>
<context>
    <name>relievo::StatusFields</name>
    <message>
        <source>Message</source>
        <translation>संदेश</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>स्थिति</translation>
    </message>
    <message>
        <source>Kind of surface</source>
        <translation>सतह का प्रकार</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>बल</translation>
    </message>
    <message>
        <source>Force rate</source>
        <translation>बल की दर</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>रिकॉर्डिंग</translation>
    </message>
    <message>
        <source>Running step</source>
        <translation>चल रहा चरण</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>प्रगति</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>रद्द करें</translation>
    </message>
    <message>
        <source>Stop this work; what is shown stays (Esc)</source>
        <translation>यह काम रोकें; जो दिख रहा है वह रहता है (Esc)</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>काम चल रहा है</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>माउस</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>रिज़ॉल्यूशन</translation>
    </message>
</context>
<context>
    <name>relievo::StepForm</name>
    <message>
        <source>What is inside</source>
        <translation>जो भीतर है</translation>
    </message>
    <message>
        <source>What is outside</source>
        <translation>जो बाहर है</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>रहता है</translation>
    </message>
    <message>
        <source>Which part of the scan stays</source>
        <translation>स्कैन का कौन सा भाग रहता है</translation>
    </message>
    <message>
        <source>x from</source>
        <translation>x से</translation>
    </message>
    <message>
        <source>x to</source>
        <translation>x तक</translation>
    </message>
    <message>
        <source>y from</source>
        <translation>y से</translation>
    </message>
    <message>
        <source>y to</source>
        <translation>y तक</translation>
    </message>
    <message>
        <source>z from</source>
        <translation>z से</translation>
    </message>
    <message>
        <source>z to</source>
        <translation>z तक</translation>
    </message>
    <message>
        <source>In the file&apos;s coordinates</source>
        <translation>फ़ाइल के निर्देशांकों में</translation>
    </message>
    <message>
        <source>&amp;Draw on the view</source>
        <translation>दृश्य पर खींचें (&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Draw it anew</source>
        <translation>नए सिरे से खींचें (&amp;D)</translation>
    </message>
    <message>
        <source>Drag the mouse round what is meant; or arrow keys and Enter for each corner, Ctrl+Enter to close</source>
        <translation>माउस से चारों ओर खींचें; या हर कोने के लिए तीर कुंजियाँ और Enter, बंद करने को Ctrl+Enter</translation>
    </message>
    <message>
        <source>No outline is drawn yet; nothing is left out.</source>
        <translation>अभी कोई रूपरेखा नहीं खींची गई; कुछ नहीं छोड़ा जाता।</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 कोने</translation>
    </message>
    <message>
        <source>Classes that stay</source>
        <translation>जो वर्ग रहते हैं</translation>
    </message>
    <message>
        <source>Numbers of LAS classes such as 2, 6; none: all</source>
        <translation>LAS वर्गों की संख्याएँ जैसे 2, 6; कोई नहीं: सभी</translation>
    </message>
    <message>
        <source>Noise stays, too</source>
        <translation>शोर भी रहता है</translation>
    </message>
    <message>
        <source>Classes 7 and 18 are marked as noise</source>
        <translation>वर्ग 7 और 18 शोर के रूप में चिह्नित हैं</translation>
    </message>
    <message>
        <source>Returns that stay</source>
        <translation>जो वापसियाँ रहती हैं</translation>
    </message>
    <message>
        <source>Of each pulse of a laser scanner; one that came back once is first, last and single</source>
        <translation>लेज़र स्कैनर के हर स्पंद की; जो स्पंद एक बार लौटा, वह पहली, अंतिम और एकमात्र वापसी है</translation>
    </message>
    <message>
        <source>First: the tops of trees and roofs</source>
        <translation>पहली: पेड़ों और छतों के ऊपरी भाग</translation>
    </message>
    <message>
        <source>Last: mostly the ground</source>
        <translation>अंतिम: प्रायः भूमि</translation>
    </message>
    <message>
        <source>Single: pulses that came back once</source>
        <translation>एकमात्र: जो स्पंद एक बार लौटे</translation>
    </message>
    <message>
        <source>From</source>
        <translation>से</translation>
    </message>
    <message>
        <source>Lowest intensity that stays, as stored</source>
        <translation>सबसे कम तीव्रता जो रहती है, जैसी सहेजी गई</translation>
    </message>
    <message>
        <source>To</source>
        <translation>तक</translation>
    </message>
    <message>
        <source>Highest intensity that stays, as stored</source>
        <translation>सबसे अधिक तीव्रता जो रहती है, जैसी सहेजी गई</translation>
    </message>
    <message>
        <source>Of points with equal coordinates the first stays.</source>
        <translation>समान निर्देशांक वाले बिंदुओं में पहला रहता है।</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>पड़ोसी</translation>
    </message>
    <message>
        <source>How many nearest points are looked at</source>
        <translation>कितने निकटतम बिंदु देखे जाते हैं</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>विचलन</translation>
    </message>
    <message>
        <source>Points farther from these than the mean and so many standard deviations go</source>
        <translation>जो बिंदु इनसे औसत और इतने मानक विचलन से अधिक दूर हैं, वे जाते हैं</translation>
    </message>
    <message>
        <source>Radius in</source>
        <translation>त्रिज्या किसमें</translation>
    </message>
    <message>
        <source>Whether the radius follows the scan&apos;s density</source>
        <translation>क्या त्रिज्या स्कैन के घनत्व के अनुसार हो</translation>
    </message>
    <message>
        <source>Spacings of the scan</source>
        <translation>स्कैन के अंतराल</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>मिलीमीटर</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>त्रिज्या</translation>
    </message>
    <message>
        <source>How far neighbours may be</source>
        <translation>पड़ोसी कितनी दूर हो सकते हैं</translation>
    </message>
    <message>
        <source>Points with fewer neighbours within the radius go</source>
        <translation>त्रिज्या के भीतर कम पड़ोसी वाले बिंदु जाते हैं</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>गुना</translation>
    </message>
    <message>
        <source>Points so many times as far from these as the densest of them go</source>
        <translation>जो बिंदु इनमें सबसे सघन से इतने गुना दूर हैं, वे जाते हैं</translation>
    </message>
    <message>
        <source>Off the surface</source>
        <translation>सतह से दूर</translation>
    </message>
    <message>
        <source>Then points go that lie so many times as far off the plane of their neighbours as others, at most 0.18 % of them</source>
        <translation>फिर वे बिंदु हटते हैं जो अपने पड़ोसियों के तल से दूसरों की तुलना में इतने गुना दूर हैं, अधिकतम 0.18 %</translation>
    </message>
    <message>
        <source>Nothing goes</source>
        <translation>कुछ नहीं हटता</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>अंतराल</translation>
    </message>
    <message>
        <source>In every cube of this side one point stays</source>
        <translation>इस भुजा के हर घन में एक बिंदु रहता है</translation>
    </message>
    <message>
        <source>Its points</source>
        <translation>उसके बिंदु</translation>
    </message>
    <message>
        <source>What becomes of the plane that holds most points</source>
        <translation>जिस तल पर सबसे अधिक बिंदु हैं उसका क्या हो</translation>
    </message>
    <message>
        <source>Are left out</source>
        <translation>छोड़े जाते हैं</translation>
    </message>
    <message>
        <source>Are laid level, with the object above them</source>
        <translation>समतल रखे जाते हैं, वस्तु ऊपर</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>दूरी</translation>
    </message>
    <message>
        <source>Nearer points are on the plane; 0: twice the scan&apos;s spacing</source>
        <translation>निकट के बिंदु तल पर हैं; 0: स्कैन के अंतराल का दुगुना</translation>
    </message>
    <message>
        <source>Twice the spacing</source>
        <translation>अंतराल का दुगुना</translation>
    </message>
    <message>
        <source>How many nearest points a normal is made of</source>
        <translation>कितने निकटतम बिंदुओं से अभिलंब बनता है</translation>
    </message>
    <message>
        <source>Where they lie</source>
        <translation>वे कहाँ हैं</translation>
    </message>
    <message>
        <source>How the scans are laid on the reference</source>
        <translation>स्कैन संदर्भ पर कैसे रखे जाते हैं</translation>
    </message>
    <message>
        <source>As stored</source>
        <translation>जैसा सहेजा गया</translation>
    </message>
    <message>
        <source>By three picked pairs</source>
        <translation>तीन चुने हुए जोड़ों से</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>स्वचालित</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>बीज</translation>
    </message>
    <message>
        <source>Another number is another search</source>
        <translation>दूसरी संख्या दूसरी खोज है</translation>
    </message>
</context>
<context>
    <name>relievo::StepList</name>
    <message>
        <source>Steps</source>
        <translation>चरण</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>चरण</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>बिंदु</translation>
    </message>
    <message>
        <source>Add s&amp;tep</source>
        <translation>चरण जोड़ें (&amp;T)</translation>
    </message>
    <message>
        <source>Choose what is done next</source>
        <translation>चुनें कि आगे क्या हो</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>हटाएँ</translation>
    </message>
    <message>
        <source>Leave the chosen step out (Delete)</source>
        <translation>चुना चरण छोड़ें (Delete)</translation>
    </message>
    <message>
        <source>Remove step</source>
        <translation>चरण हटाएँ</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>पहले</translation>
    </message>
    <message>
        <source>Do the chosen step earlier (Ctrl+Up)</source>
        <translation>चुना चरण पहले करें (Ctrl+Up)</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>बाद में</translation>
    </message>
    <message>
        <source>Do the chosen step later (Ctrl+Down)</source>
        <translation>चुना चरण बाद में करें (Ctrl+Down)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>पूर्ववत (&amp;U)</translation>
    </message>
    <message>
        <source>Undo the last change (Ctrl+Z)</source>
        <translation>अंतिम बदलाव पूर्ववत करें (Ctrl+Z)</translation>
    </message>
    <message>
        <source>R&amp;edo</source>
        <translation>फिर करें (&amp;E)</translation>
    </message>
    <message>
        <source>Redo it (Ctrl+Y)</source>
        <translation>उसे फिर करें (Ctrl+Y)</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>नहीं हुआ</translation>
    </message>
</context>
<context>
    <name>relievo::StereoPanel</name>
    <message>
        <source>At mi&amp;d height</source>
        <translation>बीच की ऊँचाई पर (&amp;D)</translation>
    </message>
    <message>
        <source>S&amp;wap eyes</source>
        <translation>आँखें बदलें (&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Keep comfortable</source>
        <translation>आरामदायक रखें (&amp;K)</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>धूसर</translation>
    </message>
    <message>
        <source>Half colour</source>
        <translation>अर्ध-रंग</translation>
    </message>
    <message>
        <source>Dubois</source>
        <translation>Dubois</translation>
    </message>
    <message>
        <source>Eye separation</source>
        <translation>आँखों की दूरी</translation>
    </message>
    <message>
        <source>Zero plane at mid height</source>
        <translation>शून्य तल बीच की ऊँचाई पर</translation>
    </message>
    <message>
        <source>The screen lies halfway between the lowest and the highest point</source>
        <translation>स्क्रीन सबसे नीचे और सबसे ऊँचे बिंदु के ठीक बीच में है</translation>
    </message>
    <message>
        <source>Zero plane</source>
        <translation>शून्य तल</translation>
    </message>
    <message>
        <source>Height that appears in the plane of the screen</source>
        <translation>वह ऊँचाई जो स्क्रीन के तल में दिखती है</translation>
    </message>
    <message>
        <source>Swap eyes</source>
        <translation>आँखें बदलें</translation>
    </message>
    <message>
        <source>For glasses whose red filter is at the right eye</source>
        <translation>उन चश्मों के लिए जिनमें लाल फ़िल्टर दाईं आँख पर है</translation>
    </message>
    <message>
        <source>Keep comfortable</source>
        <translation>आरामदायक रखें</translation>
    </message>
    <message>
        <source>Less eye separation where the two pictures would lie farther apart than the eyes like</source>
        <translation>जहाँ दोनों चित्र आँखों को रास आने से अधिक दूर हों वहाँ आँखों की कम दूरी</translation>
    </message>
    <message>
        <source>Parallax</source>
        <translation>लंबन</translation>
    </message>
    <message>
        <source>How far apart the eyes see the farthest point, at 60 cm from the screen; above 1 degree many people see double</source>
        <translation>स्क्रीन से 60 cm पर सबसे दूर का बिंदु आँखों को कितना अलग दिखता है; 1 डिग्री से ऊपर कई लोग दोहरा देखते हैं</translation>
    </message>
    <message>
        <source>Test &amp;glasses…</source>
        <translation>चश्मा जाँचें (&amp;G)…</translation>
    </message>
    <message>
        <source>Test glasses</source>
        <translation>चश्मा जाँचें</translation>
    </message>
    <message>
        <source>A picture that says whether the filters are at the right eyes</source>
        <translation>चित्र जो बताता है कि फ़िल्टर सही आँखों पर हैं या नहीं</translation>
    </message>
    <message>
        <source>K&amp;ind</source>
        <translation>प्रकार (&amp;I)</translation>
    </message>
    <message>
        <source>Eye sepa&amp;ration</source>
        <translation>आँखों की दूरी (&amp;R)</translation>
    </message>
    <message>
        <source>Zero &amp;plane</source>
        <translation>शून्य तल (&amp;P)</translation>
    </message>
    <message>
        <source>%1°, above %2°</source>
        <translation>%1°, %2° से ऊपर</translation>
    </message>
    <message>
        <source>%1° of %2°</source>
        <translation>%2° में से %1°</translation>
    </message>
    <message>
        <source>Automatic dept&amp;h</source>
        <translation>स्वचालित गहराई (&amp;H)</translation>
    </message>
    <message>
        <source>Angle between the two eyes&apos; directions; more gives more depth. A value of your own ends the automatic depth</source>
        <translation>दोनों आँखों की दिशाओं के बीच कोण; अधिक से अधिक गहराई। अपना मान देने पर स्वचालित गहराई समाप्त होती है</translation>
    </message>
    <message>
        <source>Automatic depth</source>
        <translation>स्वचालित गहराई</translation>
    </message>
    <message>
        <source>The eye separation with which the heights that are shown fill the comfortable depth</source>
        <translation>आँखों की वह दूरी जिससे दिखाई ऊँचाइयाँ आरामदायक गहराई भर दें</translation>
    </message>
    <message>
        <source>%1, automatic</source>
        <translation>%1, स्वचालित</translation>
    </message>
    <message>
        <source>Show in &amp;stereo</source>
        <translation>स्टीरियो में दिखाएँ (&amp;S)</translation>
    </message>
    <message>
        <source>Show in stereo</source>
        <translation>स्टीरियो में दिखाएँ</translation>
    </message>
    <message>
        <source>For red and cyan glasses, or for a screen for two eyes (Ctrl+3)</source>
        <translation>लाल-सियान चश्मे के लिए, या दो आँखों वाले पर्दे के लिए (Ctrl+3)</translation>
    </message>
    <message>
        <source>Kind of stereo</source>
        <translation>स्टीरियो का प्रकार</translation>
    </message>
    <message>
        <source>Grey: no colour fights with the glasses. Half colour: some colour. Dubois: least ghosts by the filters of common glasses. The others are for screens that show each eye its own half or rows; F11 gives them the whole screen</source>
        <translation>धूसर: कोई रंग चश्मे से नहीं टकराता। अर्ध-रंग: कुछ रंग। Dubois: सामान्य चश्मों के फ़िल्टरों के अनुसार सबसे कम छाया। बाक़ी ऐसे पर्दों के लिए हैं जो हर आँख को उसका आधा भाग या उसकी पंक्तियाँ दिखाते हैं; F11 उन्हें पूरा पर्दा देता है</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>अगल-बगल</translation>
    </message>
    <message>
        <source>Over and under</source>
        <translation>ऊपर-नीचे</translation>
    </message>
    <message>
        <source>Interlaced</source>
        <translation>पंक्ति-दर-पंक्ति</translation>
    </message>
</context>
<context>
    <name>relievo::StrengthRow</name>
    <message>
        <source>Gentle</source>
        <translation>कोमल</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>मध्यम</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>पूर्ण</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Strength in percent</source>
        <translation>प्रबलता प्रतिशत में</translation>
    </message>
    <message>
        <source>Multiplies every force. The limit stays.</source>
        <translation>हर बल को गुणा करता है। सीमा वही रहती है।</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>प्रबलता</translation>
    </message>
    <message>
        <source>Strength of all forces</source>
        <translation>सभी बलों की प्रबलता</translation>
    </message>
    <message>
        <source>Own strength</source>
        <translation>अपनी प्रबलता</translation>
    </message>
    <message>
        <source>How strong all forces are, in one choice.</source>
        <translation>सभी बल कितने प्रबल हैं, एक चुनाव में।</translation>
    </message>
    <message>
        <source>St&amp;rength</source>
        <translation>प्रबलता (&amp;R)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>relievo::StudyController</name>
    <message>
        <source>Stop the recording first (Ctrl+R): it belongs to this condition.</source>
        <translation>पहले रिकॉर्डिंग रोकें (Ctrl+R): वह इस शर्त की है।</translation>
    </message>
    <message>
        <source>Condition %1</source>
        <translation>शर्त %1</translation>
    </message>
    <message>
        <source>Condition %1, %2 of %3.</source>
        <translation>शर्त %1, %3 में से %2।</translation>
    </message>
    <message>
        <source>All %1 conditions were shown. The sitting is in %2.</source>
        <translation>सभी %1 शर्तें दिखाई गईं। सत्र %2 में है।</translation>
    </message>
    <message>
        <source>The sitting ended after %1 of %2 conditions. It is in %3.</source>
        <translation>सत्र %2 में से %1 शर्तों के बाद समाप्त हुआ। वह %3 में है।</translation>
    </message>
</context>
<context>
    <name>relievo::StudyDialog</name>
    <message>
        <source>Participant code</source>
        <translation>प्रतिभागी कोड</translation>
    </message>
    <message>
        <source>Letters, digits, - and _; no name. Who has which code is kept elsewhere</source>
        <translation>अक्षर, अंक, - और _; कोई नाम नहीं। किसका कौन-सा कोड है, यह कहीं और रखा जाता है</translation>
    </message>
    <message>
        <source>Note on the consent</source>
        <translation>सहमति पर टिप्पणी</translation>
    </message>
    <message>
        <source>What was agreed to, when and how, as: form 3, signed 24 November</source>
        <translation>किस बात पर, कब और कैसे सहमति हुई, जैसे: प्रपत्र 3, 24 नवंबर को हस्ताक्षरित</translation>
    </message>
    <message>
        <source>Folder of the study</source>
        <translation>अध्ययन का फ़ोल्डर</translation>
    </message>
    <message>
        <source>Each participant gets a folder in it, and each sitting one in that</source>
        <translation>हर प्रतिभागी को इसमें एक फ़ोल्डर मिलता है, और हर सत्र को उसमें एक</translation>
    </message>
    <message>
        <source>The participant has a&amp;greed</source>
        <translation>प्रतिभागी सहमत है (&amp;G)</translation>
    </message>
    <message>
        <source>Sitting of a study</source>
        <translation>अध्ययन का सत्र</translation>
    </message>
    <message>
        <source>To be asked before every sitting</source>
        <translation>हर सत्र से पहले पूछना है</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>शर्तें</translation>
    </message>
    <message>
        <source>How often each condition is shown</source>
        <translation>हर शर्त कितनी बार दिखाई जाती है</translation>
    </message>
    <message>
        <source>All once in random order, then all again in another one</source>
        <translation>सब एक बार यादृच्छिक क्रम में, फिर सब दोबारा किसी और क्रम में</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>शुरू करें (&amp;B)</translation>
    </message>
    <message>
        <source>B&amp;rowse…</source>
        <translation>ब्राउज़… (&amp;R)</translation>
    </message>
    <message>
        <source>Browse</source>
        <translation>ब्राउज़</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>दूसरी जगह चुनें</translation>
    </message>
    <message>
        <source>&amp;Participant code</source>
        <translation>प्रतिभागी कोड (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Note on the consent</source>
        <translation>सहमति पर टिप्पणी (&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Conditions</source>
        <translation>शर्तें (&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Each shown</source>
        <translation>हर एक दिखाई जाए (&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Folder of the study</source>
        <translation>अध्ययन का फ़ोल्डर (&amp;F)</translation>
    </message>
    <message>
        <source>The code has 1 to 32 letters, digits, - and _.</source>
        <translation>कोड में 1 से 32 अक्षर, अंक, - और _ होते हैं।</translation>
    </message>
    <message>
        <source>Nothing begins before the participant has agreed.</source>
        <translation>प्रतिभागी की सहमति से पहले कुछ शुरू नहीं होता।</translation>
    </message>
    <message>
        <source>Note what was agreed to.</source>
        <translation>लिखें कि किस बात पर सहमति हुई।</translation>
    </message>
    <message>
        <source>Choose at least two conditions.</source>
        <translation>कम से कम दो शर्तें चुनें।</translation>
    </message>
    <message>
        <source>Choose at most 26 conditions: they have letters.</source>
        <translation>अधिक से अधिक 26 शर्तें चुनें: उनके नाम अक्षर हैं।</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>एक फ़ोल्डर चुनें।</translation>
    </message>
    <message>
        <source>Bookmarks, each with its resolution and exaggeration. They are shown in random order, under letters</source>
        <translation>बुकमार्क, हर एक अपने रिज़ॉल्यूशन और अतिरंजन के साथ। वे यादृच्छिक क्रम में, अक्षरों के नाम से दिखाए जाते हैं</translation>
    </message>
    <message>
        <source>A study needs at least two bookmarks: Surface &gt; Add bookmark.</source>
        <translation>अध्ययन के लिए कम से कम दो बुकमार्क चाहिए: सतह &gt; बुकमार्क जोड़ें।</translation>
    </message>
</context>
<context>
    <name>relievo::SuggestPanel</name>
    <message>
        <source>Suggest windows</source>
        <translation>विंडो सुझाएँ</translation>
    </message>
    <message>
        <source>Show them in the overview</source>
        <translation>अवलोकन में दिखाएँ</translation>
    </message>
    <message>
        <source>Look for windows with relief that a hand feels (Ctrl+Shift+F)</source>
        <translation>ऐसी विंडो खोजें जिनका उभार हाथ महसूस करे (Ctrl+Shift+F)</translation>
    </message>
    <message>
        <source>Ranked by the share of a window whose relief is higher than what a hand on a grip just feels at that scale: the threshold of a fingertip (Louw, Kappers and Koenderink 2000) times %1, which is an estimate. Steep, filled and missing places do not count.</source>
        <translation>क्रम विंडो के उस भाग से, जिसका उभार उस पैमाने पर मूठ पकड़े हाथ को बस महसूस होने वाले से ऊँचा है: उँगली की सीमा (Louw, Kappers और Koenderink 2000) गुणा %1, जो अनुमान है। खड़ी, भरी और अनुपस्थित जगहें नहीं गिनी जातीं।</translation>
    </message>
    <message>
        <source>Suggested windows</source>
        <translation>सुझाई गई विंडो</translation>
    </message>
    <message>
        <source>Frames with their ranks over the whole object</source>
        <translation>पूरी वस्तु पर अपने क्रम के साथ चौखटे</translation>
    </message>
    <message>
        <source>This map is read by tiles; windows are suggested on maps in memory.</source>
        <translation>यह मानचित्र टुकड़ों में पढ़ा जाता है; विंडो स्मृति के मानचित्रों पर सुझाई जाती हैं।</translation>
    </message>
    <message>
        <source>%1 % measured, %2 % steep</source>
        <translation>%1 % मापा गया, %2 % खड़ा</translation>
    </message>
    <message>
        <source>No window has relief that stands out from what a hand just feels.</source>
        <translation>किसी विंडो में ऐसा उभार नहीं जो बस महसूस होने वाले से ऊपर हो।</translation>
    </message>
    <message>
        <source>Suggested window %1</source>
        <translation>सुझाई गई विंडो %1</translation>
    </message>
    <message>
        <source>Windows: %1, the best first</source>
        <translation>विंडो: %1, सबसे अच्छी पहले</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was suggested.</source>
        <translation>रद्द। कुछ सुझाया नहीं गया।</translation>
    </message>
    <message>
        <source>A click or Enter shows the window at its resolution; undo goes back</source>
        <translation>क्लिक या Enter विंडो को उसके रिज़ॉल्यूशन में दिखाता है; पूर्ववत लौटाता है</translation>
    </message>
    <message>
        <source>%1. Resolution %2 of %3, %4: %5 % felt, relief about %6 wide</source>
        <translation>%1. रिज़ॉल्यूशन %2, कुल %3, %4: %5 % महसूस, उभार लगभग %6 चौड़ा</translation>
    </message>
</context>
<context>
    <name>relievo::SurfaceChoices</name>
    <message>
        <source>View %1 → %2</source>
        <translation>दृश्य %1 → %2</translation>
    </message>
    <message>
        <source>Depth method → %1</source>
        <translation>विधि → %1</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>Unit %1 → %2</source>
        <translation>इकाई %1 → %2</translation>
    </message>
    <message>
        <source>Keep far-off points</source>
        <translation>दूर के बिंदु रखें</translation>
    </message>
    <message>
        <source>Leave out far-off groups</source>
        <translation>दूर के समूह छोड़ दें</translation>
    </message>
    <message>
        <source>Leave out far-off points</source>
        <translation>दूर के बिंदु छोड़ दें</translation>
    </message>
    <message>
        <source>Take heights as missing</source>
        <translation>ऊँचाइयों को अनुपस्थित मानें</translation>
    </message>
    <message>
        <source>Keep all heights</source>
        <translation>सभी ऊँचाइयाँ रखें</translation>
    </message>
    <message>
        <source>Size of the samples</source>
        <translation>नमूनों का आकार</translation>
    </message>
    <message>
        <source>Turn the relief</source>
        <translation>उभार घुमाएँ</translation>
    </message>
</context>
<context>
    <name>relievo::SurfaceController</name>
    <message>
        <source>Undone: %1</source>
        <translation>पूर्ववत किया: %1</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>फिर से किया: %1</translation>
    </message>
    <message>
        <source>Whole object</source>
        <translation>पूरी वस्तु</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>बाएँ</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>दाएँ</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>ऊपर</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>नीचे</translation>
    </message>
    <message>
        <source>This is the whole object</source>
        <translation>यह पूरी वस्तु है</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>किनारा</translation>
    </message>
    <message>
        <source>%1. Window at %2, %3 mm</source>
        <translation>%1। विंडो %2, %3 mm पर</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>undo, step</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>पूर्ववत (&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>फिर करें (&amp;R)</translation>
    </message>
    <message>
        <source>History</source>
        <translation>इतिहास</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>चरण</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>जैसा खोला गया</translation>
    </message>
    <message>
        <source>Resolution %1 of %2</source>
        <translation>रिज़ॉल्यूशन %2 में से %1</translation>
    </message>
    <message>
        <source>This is the finest resolution</source>
        <translation>यह सबसे बारीक रिज़ॉल्यूशन है</translation>
    </message>
</context>
<context>
    <name>relievo::SurfacePanel</name>
    <message>
        <source>File</source>
        <translation>फ़ाइल</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>आकार</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>ग्रिड</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>छेद</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>इकाई (&amp;U)</translation>
    </message>
    <message>
        <source>Length unit of the file&apos;s coordinates</source>
        <translation>फ़ाइल के निर्देशांकों की लंबाई इकाई</translation>
    </message>
    <message>
        <source>%1 × %2, %3 apart</source>
        <translation>%1 × %2, दूरी %3</translation>
    </message>
    <message>
        <source>none</source>
        <translation>कोई नहीं</translation>
    </message>
    <message>
        <source>Length unit of the file&apos;s coordinates (%1)</source>
        <translation>फ़ाइल के निर्देशांकों की लंबाई इकाई (%1)</translation>
    </message>
    <message>
        <source>on the base plane</source>
        <translation>आधार तल पर</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>अंतर्वेशित</translation>
    </message>
    <message>
        <source>left open</source>
        <translation>खुला छोड़ा</translation>
    </message>
    <message>
        <source>not counted; %1 % of the cells on the base plane, %2 % interpolated</source>
        <translation>गिने नहीं गए; %1 % कोष्ठ आधार तल पर, %2 % अंतर्वेशित</translation>
    </message>
</context>
<context>
    <name>relievo::TiledMapDialog</name>
    <message>
        <source>Scan</source>
        <translation>स्कैन</translation>
    </message>
    <message>
        <source>LAS, LAZ or binary PLY files and folders of them, which are one scan, or one height raster</source>
        <translation>LAS, LAZ या बाइनरी PLY फ़ाइलें और उनके फ़ोल्डर, जो मिलकर एक स्कैन हैं, या एक ऊँचाई रास्टर</translation>
    </message>
    <message>
        <source>F&amp;iles…</source>
        <translation>फ़ाइलें (&amp;I)…</translation>
    </message>
    <message>
        <source>Take files into the list</source>
        <translation>फ़ाइलें सूची में लें</translation>
    </message>
    <message>
        <source>Fo&amp;lder…</source>
        <translation>फ़ोल्डर (&amp;L)…</translation>
    </message>
    <message>
        <source>Take all LAS, LAZ and PLY files of a folder</source>
        <translation>किसी फ़ोल्डर की सभी LAS, LAZ और PLY फ़ाइलें लें</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>हटाएँ (&amp;R)</translation>
    </message>
    <message>
        <source>Take the chosen entries from the list</source>
        <translation>चुनी हुई प्रविष्टियाँ सूची से हटाएँ</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>ढूँढें (&amp;B)…</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>दूसरी जगह चुनें</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>मानचित्र</translation>
    </message>
    <message>
        <source>Where the finest level is written; the others lie beside it</source>
        <translation>सबसे बारीक स्तर कहाँ लिखा जाए; बाक़ी उसके पास रहते हैं</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>फ़ाइल की इकाई</translation>
    </message>
    <message>
        <source>Length unit of the file&apos;s coordinates</source>
        <translation>फ़ाइल के निर्देशांकों की लंबाई इकाई</translation>
    </message>
    <message>
        <source>View</source>
        <translation>दृश्य</translation>
    </message>
    <message>
        <source>From which side the object is seen</source>
        <translation>वस्तु किस ओर से देखी जाती है</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>मेमोरी</translation>
    </message>
    <message>
        <source>What the work may take beside the program itself</source>
        <translation>प्रोग्राम के अलावा काम कितनी मेमोरी ले सकता है</translation>
    </message>
    <message>
        <source>Cores</source>
        <translation>कोर</translation>
    </message>
    <message>
        <source>How many work at once</source>
        <translation>एक साथ कितने काम करें</translation>
    </message>
    <message>
        <source>&amp;Keep what is finished, to go on after a stop</source>
        <translation>जो पूरा हुआ उसे रखें, ताकि रुकने के बाद आगे बढ़ा जा सके (&amp;K)</translation>
    </message>
    <message>
        <source>Keep what is finished, to go on after a stop</source>
        <translation>जो पूरा हुआ उसे रखें, ताकि रुकने के बाद आगे बढ़ा जा सके</translation>
    </message>
    <message>
        <source>In a folder beside the map, until the map is made</source>
        <translation>मानचित्र के पास एक फ़ोल्डर में, जब तक मानचित्र न बन जाए</translation>
    </message>
    <message>
        <source>&amp;Open the map when it is made</source>
        <translation>बन जाने पर मानचित्र खोलें (&amp;O)</translation>
    </message>
    <message>
        <source>Open the map when it is made</source>
        <translation>बन जाने पर मानचित्र खोलें</translation>
    </message>
    <message>
        <source>In the place of what is open</source>
        <translation>जो खुला है उसकी जगह</translation>
    </message>
    <message>
        <source>What is ready</source>
        <translation>जो तैयार है</translation>
    </message>
    <message>
        <source>From the file</source>
        <translation>फ़ाइल से</translation>
    </message>
    <message>
        <source>All</source>
        <translation>सभी</translation>
    </message>
    <message>
        <source>Map by tiles</source>
        <translation>टाइलों से मानचित्र</translation>
    </message>
    <message>
        <source>Scans and height rasters (*.las *.laz *.ply *.tif *.tiff *.asc *.png);;All files (*)</source>
        <translation>स्कैन और ऊँचाई रास्टर (*.las *.laz *.ply *.tif *.tiff *.asc *.png);;सभी फ़ाइलें (*)</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>मानचित्र (&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>फ़ाइल की इकाई (&amp;U)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>दृश्य (&amp;V)</translation>
    </message>
    <message>
        <source>M&amp;emory</source>
        <translation>मेमोरी (&amp;E)</translation>
    </message>
    <message>
        <source>What is ready of the map</source>
        <translation>मानचित्र का जो हिस्सा तैयार है</translation>
    </message>
    <message>
        <source>While the map is made, what is ready of it is shown here.</source>
        <translation>मानचित्र बनते समय उसका तैयार हिस्सा यहाँ दिखता है।</translation>
    </message>
    <message>
        <source>M&amp;ake</source>
        <translation>बनाएँ (&amp;A)</translation>
    </message>
    <message>
        <source>Make the map</source>
        <translation>मानचित्र बनाएँ</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif)</source>
        <translation>GeoTIFF (*.tif)</translation>
    </message>
    <message>
        <source>Nothing of it can be seen yet.</source>
        <translation>अभी उसका कुछ दिखता नहीं।</translation>
    </message>
    <message>
        <source>Sca&amp;n</source>
        <translation>स्कैन (&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Cores</source>
        <translation>कोर (&amp;C)</translation>
    </message>
</context>
<context>
    <name>relievo::TilesController</name>
    <message>
        <source>about %1 s left of it</source>
        <translation>लगभग %1 से॰ शेष</translation>
    </message>
    <message>
        <source>about %1 min left of it</source>
        <translation>लगभग %1 मि॰ शेष</translation>
    </message>
    <message>
        <source>about %1 h left of it</source>
        <translation>लगभग %1 घं॰ शेष</translation>
    </message>
    <message>
        <source>From a sample of the points: %1 × %2 cells of %3, %4 high.</source>
        <translation>बिंदुओं के एक नमूने से: %3 की %1 × %2 कोशिकाएँ, ऊँचाई %4।</translation>
    </message>
    <message>
        <source>Cancelled. No map was made.</source>
        <translation>रद्द किया गया। कोई मानचित्र नहीं बना।</translation>
    </message>
    <message>
        <source>Cancelled. No map was made; what was finished is kept in %1, and the same choices go on there.</source>
        <translation>रद्द किया गया। कोई मानचित्र नहीं बना; जो पूरा हुआ वह %1 में रखा है, और यही विकल्प वहीं से आगे बढ़ते हैं।</translation>
    </message>
    <message>
        <source>%1 is made: %2 × %3 cells, %4 levels.</source>
        <translation>%1 बन गया: %2 × %3 कोशिकाएँ, %4 स्तर।</translation>
    </message>
    <message>
        <source>All heights of %1 × %2 cells are there; gaps are looked for.</source>
        <translation>%1 × %2 कोशिकाओं की सभी ऊँचाइयाँ तैयार हैं; खाली जगहें खोजी जा रही हैं।</translation>
    </message>
    <message>
        <source>%1 of %2 rows have their heights, from below; the rest is from a sample of the points.</source>
        <translation>नीचे से %2 में से %1 पंक्तियों की ऊँचाइयाँ तैयार हैं; बाकी बिंदुओं के एक नमूने से है।</translation>
    </message>
</context>
<context>
    <name>relievo::TimePlot</name>
    <message>
        <source>Height of hand and proxy over the last ten seconds</source>
        <translation>पिछले दस सेकंड में हाथ और प्रॉक्सी की ऊँचाई</translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation>z (mm)</translation>
    </message>
    <message>
        <source>Force over the last ten seconds</source>
        <translation>पिछले दस सेकंड में बल</translation>
    </message>
    <message>
        <source>force (N)</source>
        <translation>बल (N)</translation>
    </message>
    <message>
        <source>Plots of height and force</source>
        <translation>ऊँचाई और बल के आलेख</translation>
    </message>
</context>
<context>
    <name>relievo::TouchActions</name>
    <message>
        <source>&amp;Forces on</source>
        <translation>बल चालू (&amp;F)</translation>
    </message>
    <message>
        <source>Switch forces on or off (F5)</source>
        <translation>बल चालू या बंद करें (F5)</translation>
    </message>
    <message>
        <source>Forces come on gently, once the hand is clear of the surface.</source>
        <translation>हाथ के सतह से हटते ही बल धीरे-धीरे आते हैं।</translation>
    </message>
    <message>
        <source>Forces &amp;off now</source>
        <translation>बल अभी बंद (&amp;O)</translation>
    </message>
    <message>
        <source>Switch forces off (Esc)</source>
        <translation>बल बंद करें (Esc)</translation>
    </message>
    <message>
        <source>Escape always stops the forces first.</source>
        <translation>Escape हमेशा पहले बल रोकता है।</translation>
    </message>
    <message>
        <source>&amp;Stronger</source>
        <translation>और प्रबल (&amp;S)</translation>
    </message>
    <message>
        <source>Raise the strength of all forces by 10 %</source>
        <translation>सब बलों की प्रबलता 10 % बढ़ाएँ</translation>
    </message>
    <message>
        <source>Strength multiplies every force; the limit stays.</source>
        <translation>प्रबलता हर बल को गुणा करती है; सीमा वही रहती है।</translation>
    </message>
    <message>
        <source>&amp;Weaker</source>
        <translation>कम प्रबल (&amp;W)</translation>
    </message>
    <message>
        <source>Lower the strength of all forces by 10 %</source>
        <translation>सब बलों की प्रबलता 10 % घटाएँ</translation>
    </message>
    <message>
        <source>De&amp;vice set-up…</source>
        <translation>उपकरण की तैयारी (&amp;V)…</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>रिकॉर्ड करें (&amp;R)</translation>
    </message>
    <message>
        <source>Start or stop recording every sample (Ctrl+R)</source>
        <translation>हर नमूने की रिकॉर्डिंग शुरू या बंद करें (Ctrl+R)</translation>
    </message>
    <message>
        <source>Writes hand, proxy and force, 1000 times a second, to a table in your documents folder.</source>
        <translation>हाथ, प्रॉक्सी और बल, प्रति सेकंड 1000 बार, आपके दस्तावेज़ फ़ोल्डर की तालिका में लिखता है।</translation>
    </message>
    <message>
        <source>&amp;Use the mouse</source>
        <translation>माउस का उपयोग करें (&amp;U)</translation>
    </message>
    <message>
        <source>Let the mouse be the hand</source>
        <translation>माउस को हाथ बनाएँ</translation>
    </message>
    <message>
        <source>Lets go of a Falcon, whether it is ready or still starting or homing.</source>
        <translation>Falcon को छोड़ देता है, चाहे वह तैयार हो, शुरू हो रहा हो या आरंभ स्थिति खोज रहा हो।</translation>
    </message>
    <message>
        <source>&amp;Move mode</source>
        <translation>खिसकाने की विधा (&amp;M)</translation>
    </message>
    <message>
        <source>Begin Move mode, or confirm and leave it (Ctrl+Shift+M)</source>
        <translation>खिसकाने की विधा शुरू करें, या पुष्टि करके छोड़ें (Ctrl+Shift+M)</translation>
    </message>
    <message>
        <source>Pushing the grip to a side moves the window there, one click per quarter.</source>
        <translation>मूठ को एक ओर धकेलने से विंडो उधर खिसकती है, हर चौथाई पर एक क्लिक।</translation>
    </message>
    <message>
        <source>&amp;Back to the old window</source>
        <translation>पुरानी विंडो पर वापस (&amp;B)</translation>
    </message>
    <message>
        <source>Leave Move mode and go back to where it began</source>
        <translation>खिसकाने की विधा छोड़ें और जहाँ शुरू हुई वहाँ लौटें</translation>
    </message>
    <message>
        <source>The device&apos;s button Centre does the same in Move mode.</source>
        <translation>खिसकाने की विधा में उपकरण का बीच का बटन यही करता है।</translation>
    </message>
    <message>
        <source>Where am &amp;I</source>
        <translation>मैं कहाँ हूँ (&amp;I)</translation>
    </message>
    <message>
        <source>Say where the hand is (Ctrl+I)</source>
        <translation>बताएँ कि हाथ कहाँ है (Ctrl+I)</translation>
    </message>
    <message>
        <source>Place and height under the hand, and whether it was measured.</source>
        <translation>हाथ के नीचे की जगह और ऊँचाई, और वह मापी गई थी या नहीं।</translation>
    </message>
    <message>
        <source>How large the window is and what one millimetre of hand is.</source>
        <translation>विंडो कितनी बड़ी है और हाथ का एक मिलीमीटर क्या है।</translation>
    </message>
    <message>
        <source>Button &amp;help</source>
        <translation>बटनों की सहायता (&amp;H)</translation>
    </message>
    <message>
        <source>Say what the device&apos;s buttons do now</source>
        <translation>बताएँ कि उपकरण के बटन अभी क्या करते हैं</translation>
    </message>
    <message>
        <source>It differs in Move mode and while scanning with one button.</source>
        <translation>खिसकाने की विधा में और एक बटन से चुनाव में यह अलग होता है।</translation>
    </message>
    <message>
        <source>Add &amp;note…</source>
        <translation>टिप्पणी जोड़ें (&amp;N)…</translation>
    </message>
    <message>
        <source>Write a note into the running recording (Ctrl+Shift+N)</source>
        <translation>चल रही रिकॉर्डिंग में टिप्पणी लिखें (Ctrl+Shift+N)</translation>
    </message>
    <message>
        <source>It belongs to the moment at which this is chosen; the recording goes on while you write.</source>
        <translation>वह उस क्षण की होती है जब इसे चुना जाए; लिखते समय रिकॉर्डिंग चलती रहती है।</translation>
    </message>
    <message>
        <source>Wh&amp;ere am I, in full</source>
        <translation>मैं कहाँ हूँ, पूरे में (&amp;E)</translation>
    </message>
    <message>
        <source>Also the distances from the object&apos;s edges, and how fine the shown samples are.</source>
        <translation>वस्तु के किनारों से दूरियाँ भी, और दिखाए गए नमूने कितने सूक्ष्म हैं।</translation>
    </message>
    <message>
        <source>&amp;Guide along the outline</source>
        <translation>रूपरेखा के साथ ले चलना (&amp;G)</translation>
    </message>
    <message>
        <source>Lead the hand along the nearest outline, or let go (Ctrl+Alt+G)</source>
        <translation>हाथ को सबसे पास की रूपरेखा के साथ ले चलें, या छोड़ दें (Ctrl+Alt+G)</translation>
    </message>
    <message>
        <source>Of a raised or sunken area, or of the object; with 2 N at most. Push against it or press any button, and it lets go.</source>
        <translation>किसी उभरे या धँसे भाग की, या वस्तु की; अधिक से अधिक 2 N से। विरोध में धकेलें या कोई बटन दबाएँ, तो वह छोड़ देता है।</translation>
    </message>
    <message>
        <source>Guide along a re&amp;cording…</source>
        <translation>रिकॉर्डिंग के साथ ले चलना (&amp;C)…</translation>
    </message>
    <message>
        <source>Lead the hand as somebody&apos;s hand went in a recording or stroke</source>
        <translation>हाथ को वैसे ले चलें जैसे किसी का हाथ रिकॉर्डिंग या रास्ते में गया था</translation>
    </message>
    <message>
        <source>At that hand&apos;s own speed, 15 to 60 mm/s, and with its rests.</source>
        <translation>उस हाथ की अपनी गति से, 15 से 60 mm/s, और उसके ठहरावों के साथ।</translation>
    </message>
    <message>
        <source>Five shapes to find under the hand, in two minutes (Ctrl+Alt+U)</source>
        <translation>हाथ के नीचे पाँच आकार खोजें, दो मिनट में (Ctrl+Alt+U)</translation>
    </message>
    <message>
        <source>A plate, a bump, a step, waves and a groove take the place of the relief; each task is said, and each can be passed over.</source>
        <translation>उभार की जगह एक पट्टी, एक उभार, एक सीढ़ी, लहरें और एक खाँचा आते हैं; हर काम बोला जाता है, और हर एक छोड़ा जा सकता है।</translation>
    </message>
    <message>
        <source>Ne&amp;xt shape</source>
        <translation>अगला आकार (&amp;X)</translation>
    </message>
    <message>
        <source>Go on to the introduction&apos;s next shape (Ctrl+Alt+N)</source>
        <translation>परिचय के अगले आकार पर जाएँ (Ctrl+Alt+N)</translation>
    </message>
    <message>
        <source>The device&apos;s button Forward does the same in the introduction.</source>
        <translation>परिचय में उपकरण का बटन आगे भी यही करता है।</translation>
    </message>
    <message>
        <source>I&amp;ntroduction to touch</source>
        <translation>स्पर्श का परिचय (&amp;N)</translation>
    </message>
    <message>
        <source>G&amp;amepads rumble</source>
        <translation>गेमपैड कँपें (&amp;A)</translation>
    </message>
    <message>
        <source>Let gamepads rumble at contact and edge: a cue, no force</source>
        <translation>छूने पर और किनारे पर गेमपैड को कँपने दें: संकेत, बल नहीं</translation>
    </message>
    <message>
        <source>A knock when the hand meets the surface, and a soft hum at the edge of the window. The panel Buttons has the same switch.</source>
        <translation>हाथ के सतह से मिलने पर एक ठोकर, और विंडो के किनारे पर हल्की गूँज। पैनल बटन में यही स्विच है।</translation>
    </message>
    <message>
        <source>Ta&amp;ke the forces back</source>
        <translation>बल वापस लें (&amp;K)</translation>
    </message>
    <message>
        <source>Open a device again that took its forces away (Shift+F5)</source>
        <translation>जिस उपकरण ने अपने बल हटा लिए, उसे फिर खोलें (Shift+F5)</translation>
    </message>
    <message>
        <source>The device is closed and opened; its forces rise from zero once the hand is clear of the surface.</source>
        <translation>उपकरण बंद करके खोला जाता है; हाथ के सतह से अलग होते ही उसके बल शून्य से बढ़ते हैं।</translation>
    </message>
    <message>
        <source>Pla&amp;y sounds of touch</source>
        <translation>स्पर्श की ध्वनियाँ (&amp;Y)</translation>
    </message>
    <message>
        <source>Hear what the hand meets, while it touches (Ctrl+Alt+A)</source>
        <translation>छूते समय सुनें कि हाथ किससे मिलता है (Ctrl+Alt+A)</translation>
    </message>
    <message>
        <source>A click at contact, a rustle while sliding, a tone that is higher where the surface is; the edge and filled ground. The tone ends after two minutes.</source>
        <translation>छूने पर एक क्लिक, फिसलने पर सरसराहट, एक स्वर जो वहाँ ऊँचा होता है जहाँ सतह ऊँची है; किनारा और भरी हुई ज़मीन। स्वर दो मिनट बाद रुक जाता है।</translation>
    </message>
    <message>
        <source>Ma&amp;ke sounds louder</source>
        <translation>ध्वनियाँ तेज़ (&amp;K)</translation>
    </message>
    <message>
        <source>Make the sounds of touch louder (Ctrl+Alt+Page Up)</source>
        <translation>स्पर्श की ध्वनियाँ तेज़ करें (Ctrl+Alt+Page Up)</translation>
    </message>
    <message>
        <source>Speech has a volume of its own.</source>
        <translation>बोली की अपनी अलग ध्वनि-मात्रा है।</translation>
    </message>
    <message>
        <source>Sounds &amp;quieter</source>
        <translation>ध्वनियाँ धीमी (&amp;Q)</translation>
    </message>
    <message>
        <source>Make the sounds of touch quieter (Ctrl+Alt+Page Down)</source>
        <translation>स्पर्श की ध्वनियाँ धीमी करें (Ctrl+Alt+Page Down)</translation>
    </message>
    <message>
        <source>Felt &amp;patterns</source>
        <translation>स्पर्श संकेत (&amp;P)</translation>
    </message>
    <message>
        <source>Taps of the grip say what sounds say, for who does not hear them</source>
        <translation>हैंडल की थपकियाँ वही बताती हैं जो ध्वनियाँ, उनके लिए जो सुन नहीं पाते</translation>
    </message>
    <message>
        <source>One tap: yes. Two: not measured. Three: the edge. Only while forces are on.</source>
        <translation>एक थपकी: हाँ। दो: मापा नहीं गया। तीन: किनारा। केवल जब बल चालू हों।</translation>
    </message>
    <message>
        <source>Set up a Falcon or a Haply device, step by step</source>
        <translation>Falcon या Haply उपकरण को क़दम-दर-क़दम तैयार करें</translation>
    </message>
    <message>
        <source>From plug to touch. A Falcon: access, firmware, homing, self test, force by a known weight, left or right hand. Haply: service, power, calibration, buttons.</source>
        <translation>जोड़ने से स्पर्श तक। Falcon: पहुँच, फ़र्मवेयर, आरंभ स्थिति, स्व-परीक्षण, ज्ञात भार से बल, बायाँ या दायाँ हाथ। Haply: सेवा, बिजली, अंशांकन, बटन।</translation>
    </message>
    <message>
        <source>Next strength &amp;preset</source>
        <translation>अगली प्रबलता (&amp;P)</translation>
    </message>
    <message>
        <source>Gentle, medium and full strength, one after another (Ctrl+Alt+F)</source>
        <translation>कोमल, मध्यम और पूर्ण प्रबलता, एक के बाद एक (Ctrl+Alt+F)</translation>
    </message>
    <message>
        <source>The panel Touch has the same choice, and every strength between.</source>
        <translation>पैनल स्पर्श में यही चुनाव है, और बीच की हर प्रबलता।</translation>
    </message>
    <message>
        <source>Next grip posi&amp;tion</source>
        <translation>ग्रिप की अगली स्थिति (&amp;T)</translation>
    </message>
    <message>
        <source>How the device stands: upright, flat, at the left or the right, one after another (Ctrl+Alt+H)</source>
        <translation>उपकरण कैसे खड़ा है: खड़ा, लेटा, बाएँ या दाएँ, एक के बाद एक (Ctrl+Alt+H)</translation>
    </message>
    <message>
        <source>Which way the grip is pushed to press into the relief. Forces go off first.</source>
        <translation>उभार में दबाने के लिए ग्रिप किधर धकेली जाती है। पहले बल बंद हो जाते हैं।</translation>
    </message>
    <message>
        <source>Say where the hand is, with edges, resolution and scale (Ctrl+Alt+I)</source>
        <translation>बताए कि हाथ कहाँ है, किनारों, रिज़ॉल्यूशन और पैमाने सहित (Ctrl+Alt+I)</translation>
    </message>
    <message>
        <source>Say resolution, window and hand scale (Ctrl+Shift+I)</source>
        <translation>रिज़ॉल्यूशन, विंडो और हाथ का पैमाना बताएँ (Ctrl+Shift+I)</translation>
    </message>
    <message>
        <source>Resolution an&amp;d scale</source>
        <translation>रिज़ॉल्यूशन और पैमाना (&amp;D)</translation>
    </message>
</context>
<context>
    <name>relievo::TouchController</name>
    <message>
        <source>measured</source>
        <translation>मापा गया</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>अंतर्वेशित</translation>
    </message>
    <message>
        <source>hole, on base plane</source>
        <translation>छेद, आधार तल पर</translation>
    </message>
    <message>
        <source>steep</source>
        <translation>तीव्र ढाल</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>बाहर</translation>
    </message>
    <message>
        <source>Press depth %1 mm of hand</source>
        <translation>दबाने की गहराई हाथ के %1 mm</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3 mm</source>
        <translation>x %1  y %2  z %3 mm</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Force when it was recorded</source>
        <translation>रिकॉर्डिंग के समय का बल</translation>
    </message>
    <message>
        <source>replay %1</source>
        <translation>पुनर्प्रदर्शन %1</translation>
    </message>
    <message>
        <source>%1/%2 N</source>
        <translation>%1/%2 N</translation>
    </message>
    <message>
        <source>forces off</source>
        <translation>बल बंद</translation>
    </message>
    <message>
        <source>Force on the hand and its limit</source>
        <translation>हाथ पर बल और उसकी सीमा</translation>
    </message>
    <message>
        <source>Press F5 to switch forces on</source>
        <translation>बल चालू करने के लिए F5 दबाएँ</translation>
    </message>
    <message>
        <source>Forces are on: the replay was closed.</source>
        <translation>बल चालू हैं: पुनर्प्रदर्शन बंद किया गया।</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>उपकरण: %1</translation>
    </message>
    <message>
        <source>Worst period: %1 ms</source>
        <translation>सबसे लंबी अवधि: %1 ms</translation>
    </message>
    <message>
        <source>Real-time priority</source>
        <translation>रीयल-टाइम प्राथमिकता</translation>
    </message>
    <message>
        <source>No real-time priority: %1</source>
        <translation>रीयल-टाइम प्राथमिकता नहीं: %1</translation>
    </message>
    <message>
        <source>%1/s, late %2</source>
        <translation>%1/s, देर %2</translation>
    </message>
    <message>
        <source>recording %1</source>
        <translation>रिकॉर्डिंग %1</translation>
    </message>
    <message>
        <source>Touch is not available: %1 Viewing works.</source>
        <translation>स्पर्श उपलब्ध नहीं: %1 देखना चलता है।</translation>
    </message>
    <message>
        <source>Nothing is open. Open a scan with Ctrl+O.</source>
        <translation>कुछ खुला नहीं है। Ctrl+O से स्कैन खोलें।</translation>
    </message>
    <message>
        <source>%1, %2. Resolution %3 of %4</source>
        <translation>%1, %2। रिज़ॉल्यूशन %4 में से %3</translation>
    </message>
    <message>
        <source>%1, %2 by %3 mm, in %4 resolutions. Push the hand in to touch; F5 switches forces on. Plus: finer; Minus: coarser; both for two seconds: help.</source>
        <translation>%1, %2 गुणा %3 mm, %4 रिज़ॉल्यूशनों में। छूने के लिए हाथ भीतर दबाएँ; F5 बल चालू करता है। प्लस: और बारीक; माइनस: और मोटा; दोनों दो सेकंड: सहायता।</translation>
    </message>
</context>
<context>
    <name>relievo::TouchGuide</name>
    <message>
        <source>The recorded way leaves the shown window. Go to where it was recorded.</source>
        <translation>रिकॉर्ड किया रास्ता दिखाई गई विंडो से बाहर जाता है। वहाँ जाएँ जहाँ वह रिकॉर्ड हुआ था।</translation>
    </message>
</context>
<context>
    <name>relievo::TouchedSurface</name>
    <message>
        <source>Stiffness map: %1.</source>
        <translation>कठोरता मानचित्र: %1।</translation>
    </message>
    <message>
        <source>Stiffness map: %1. Set Not measured below 100 % to feel it.</source>
        <translation>कठोरता मानचित्र: %1। इसे महसूस करने के लिए “मापा नहीं गया” को 100 % से कम रखें।</translation>
    </message>
    <message>
        <source>The surface is stiff where it was measured.</source>
        <translation>जहाँ मापा गया वहाँ सतह कठोर है।</translation>
    </message>
</context>
<context>
    <name>relievo::VideoControl</name>
    <message>
        <source>Video saved: %1 s, %2 frames in %3</source>
        <translation>वीडियो सहेजा गया: %1 s, %3 में %2 फ़्रेम</translation>
    </message>
    <message>
        <source>Cancelled. No video was kept.</source>
        <translation>रद्द किया गया। कोई वीडियो नहीं रखा गया।</translation>
    </message>
    <message>
        <source>Video saved: %1 s, %2 pictures dropped, in %3</source>
        <translation>वीडियो सहेजा गया: %1 s, %2 चित्र छूटे, %3 में</translation>
    </message>
    <message>
        <source>The video has ended early</source>
        <translation>वीडियो समय से पहले समाप्त हुआ</translation>
    </message>
    <message>
        <source>The video has no sound.</source>
        <translation>वीडियो में ध्वनि नहीं है।</translation>
    </message>
</context>
<context>
    <name>relievo::VideoController</name>
    <message>
        <source>End of the camera path</source>
        <translation>कैमरा पथ का अंत</translation>
    </message>
    <message>
        <source>The camera path is empty</source>
        <translation>कैमरा पथ खाली है</translation>
    </message>
    <message>
        <source>The program ffmpeg is not installed: a folder of pictures can be made.</source>
        <translation>प्रोग्राम ffmpeg स्थापित नहीं है: चित्रों का फ़ोल्डर बनाया जा सकता है।</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>वीडियो</translation>
    </message>
    <message>
        <source>A folder of pictures (*)</source>
        <translation>चित्रों का फ़ोल्डर (*)</translation>
    </message>
    <message>
        <source>Videos (*.mp4)</source>
        <translation>वीडियो (*.mp4)</translation>
    </message>
    <message>
        <source>Video to %1</source>
        <translation>%1 में वीडियो</translation>
    </message>
    <message>
        <source>The program ffmpeg, which packs videos, is not installed. Nothing was made. Install the package ffmpeg, or keep a folder of pictures.</source>
        <translation>वीडियो बनाने वाला प्रोग्राम ffmpeg स्थापित नहीं है। कुछ नहीं बनाया गया। पैकेज ffmpeg स्थापित करें, या चित्रों का फ़ोल्डर रखें।</translation>
    </message>
    <message>
        <source>&amp;Keep pictures</source>
        <translation>चित्र रखें (&amp;K)</translation>
    </message>
    <message>
        <source>Camera path</source>
        <translation>कैमरा पथ</translation>
    </message>
    <message>
        <source>Key view %1 at %2 s</source>
        <translation>मुख्य दृश्य %1, %2 s पर</translation>
    </message>
</context>
<context>
    <name>relievo::VideoDialog</name>
    <message>
        <source>Video</source>
        <translation>वीडियो</translation>
    </message>
    <message>
        <source>&amp;For</source>
        <translation>किसके लिए (&amp;F)</translation>
    </message>
    <message>
        <source>How the pictures are packed: small, or without loss</source>
        <translation>चित्र कैसे संपीडित हों: छोटे, या बिना हानि के</translation>
    </message>
    <message>
        <source>Talk: plays everywhere</source>
        <translation>व्याख्यान: हर जगह चलता है</translation>
    </message>
    <message>
        <source>Archive: every pixel comes back</source>
        <translation>संग्रह: हर पिक्सेल वापस मिलता है</translation>
    </message>
    <message>
        <source>Anaglyph: for red and cyan glasses</source>
        <translation>एनाग्लिफ़: लाल-सियान चश्मे के लिए</translation>
    </message>
    <message>
        <source>Images: a folder of pictures</source>
        <translation>चित्र: चित्रों का फ़ोल्डर</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>आकार (&amp;S)</translation>
    </message>
    <message>
        <source>Of each picture, in pixels</source>
        <translation>हर चित्र का, पिक्सेल में</translation>
    </message>
    <message>
        <source>As the detail view: %1 × %2</source>
        <translation>विवरण दृश्य जैसा: %1 × %2</translation>
    </message>
    <message>
        <source>&amp;Pictures a second</source>
        <translation>प्रति सेकंड चित्र (&amp;P)</translation>
    </message>
    <message>
        <source>30 look smooth; 24 to 60 are usual</source>
        <translation>30 सहज लगते हैं; 24 से 60 सामान्य हैं</translation>
    </message>
    <message>
        <source>&amp;Choose file…</source>
        <translation>फ़ाइल चुनें… (&amp;C)</translation>
    </message>
    <message>
        <source>Sp&amp;eed</source>
        <translation>गति (&amp;E)</translation>
    </message>
    <message>
        <source>1 as it was; 0.25 four times slower</source>
        <translation>1 जैसा था; 0.25 चार गुना धीमा</translation>
    </message>
    <message>
        <source>F&amp;rom</source>
        <translation>यहाँ से (&amp;R)</translation>
    </message>
    <message>
        <source>Where it begins, since the start of recording or path</source>
        <translation>कहाँ से शुरू हो, रिकॉर्डिंग या पथ के आरंभ से</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>यहाँ तक (&amp;T)</translation>
    </message>
    <message>
        <source>Where it ends, since the start of recording or path</source>
        <translation>कहाँ समाप्त हो, रिकॉर्डिंग या पथ के आरंभ से</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>P&amp;lots</source>
        <translation>आलेख (&amp;L)</translation>
    </message>
    <message>
        <source>Height of hand and proxy, and the force, below</source>
        <translation>नीचे हाथ और प्रॉक्सी की ऊँचाई, और बल</translation>
    </message>
    <message>
        <source>&amp;Whole object</source>
        <translation>पूरी वस्तु (&amp;W)</translation>
    </message>
    <message>
        <source>The whole object with the pink window, beside the detail</source>
        <translation>विवरण के पास पूरी वस्तु, गुलाबी विंडो के साथ</translation>
    </message>
    <message>
        <source>Scale &amp;bar</source>
        <translation>पैमाना पट्टी (&amp;B)</translation>
    </message>
    <message>
        <source>How long a millimetre is in the detail</source>
        <translation>विवरण में एक मिलीमीटर कितना लंबा है</translation>
    </message>
    <message>
        <source>Along the camera pat&amp;h</source>
        <translation>कैमरा पथ के साथ (&amp;H)</translation>
    </message>
    <message>
        <source>The camera passes the key views; else it looks at the recorded window</source>
        <translation>कैमरा मुख्य दृश्यों से गुज़रता है; नहीं तो वह रिकॉर्ड की गई विंडो को देखता है</translation>
    </message>
    <message>
        <source>Stere&amp;o</source>
        <translation>स्टीरियो (&amp;O)</translation>
    </message>
    <message>
        <source>Red and cyan pictures; not for talks, whose colours are halved</source>
        <translation>लाल-सियान चित्र; व्याख्यानों के लिए नहीं, जिनके रंग आधे किए जाते हैं</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>बंद</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>धूसर</translation>
    </message>
    <message>
        <source>Half colour</source>
        <translation>अर्ध-रंग</translation>
    </message>
    <message>
        <source>Dubois</source>
        <translation>Dubois</translation>
    </message>
    <message>
        <source>Eye sep&amp;aration</source>
        <translation>आँखों की दूरी (&amp;A)</translation>
    </message>
    <message>
        <source>Angle between the two eyes&apos; directions</source>
        <translation>दोनों आँखों की दिशाओं के बीच का कोण</translation>
    </message>
    <message>
        <source>Swap e&amp;yes</source>
        <translation>आँखें बदलें (&amp;Y)</translation>
    </message>
    <message>
        <source>For glasses whose red filter is at the right eye</source>
        <translation>उन चश्मों के लिए जिनमें लाल फ़िल्टर दाईं आँख पर है</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>अगल-बगल</translation>
    </message>
    <message>
        <source>Over and under</source>
        <translation>ऊपर-नीचे</translation>
    </message>
    <message>
        <source>Interlaced</source>
        <translation>पंक्ति-दर-पंक्ति</translation>
    </message>
    <message>
        <source>Both eyes as f&amp;iles</source>
        <translation>दोनों आँखें फ़ाइलों में (&amp;I)</translation>
    </message>
    <message>
        <source>Also each eye&apos;s video as a file of its own: NAME.left.mp4 and NAME.right.mp4</source>
        <translation>हर आँख का वीडियो भी अलग फ़ाइल में: NAME.left.mp4 और NAME.right.mp4</translation>
    </message>
    <message>
        <source>So&amp;und</source>
        <translation>ध्वनि (&amp;U)</translation>
    </message>
    <message>
        <source>What the hand met, at its time: clicks, rustling and the tone of heights; a folder of pictures has none</source>
        <translation>हाथ को जो मिला, उसके अपने समय पर: क्लिक, सरसराहट और ऊँचाइयों का स्वर; चित्रों के फ़ोल्डर में ध्वनि नहीं होती</translation>
    </message>
</context>
<context>
    <name>relievo::ViewPanel</name>
    <message>
        <source>Seen from</source>
        <translation>किस ओर से</translation>
    </message>
    <message>
        <source>Look from this side (Alt+%1)</source>
        <translation>इस ओर से देखें (Alt+%1)</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>स्वचालित</translation>
    </message>
    <message>
        <source>Look from the side that shows most</source>
        <translation>उस ओर से देखें जहाँ से सबसे अधिक दिखे</translation>
    </message>
    <message>
        <source>Use this view</source>
        <translation>यह दृश्य लें</translation>
    </message>
    <message>
        <source>Make the depth map from where the turned detail view looks</source>
        <translation>घुमाए गए विवरण दृश्य की दिशा से गहराई मानचित्र बनाएँ</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>सीधा करें</translation>
    </message>
    <message>
        <source>Look straight down on the relief again</source>
        <translation>उभार को फिर सीधे ऊपर से देखें</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>प्रकाश</translation>
    </message>
    <message>
        <source>Direction of the light</source>
        <translation>प्रकाश की दिशा</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 is above, clockwise</source>
        <translation>प्रकाश कहाँ से आता है: 0 ऊपर है, घड़ी की दिशा में</translation>
    </message>
    <message>
        <source>Height of the light</source>
        <translation>प्रकाश की ऊँचाई</translation>
    </message>
    <message>
        <source>Low light brings out worn detail</source>
        <translation>नीचा प्रकाश घिसे विवरण उभारता है</translation>
    </message>
    <message>
        <source>Light from %1°, %2° high</source>
        <translation>प्रकाश %1° से, %2° ऊँचा</translation>
    </message>
    <message>
        <source>Seen from: %1</source>
        <translation>किस ओर से: %1</translation>
    </message>
    <message>
        <source>Shading of colours</source>
        <translation>रंगों का छायांकन</translation>
    </message>
    <message>
        <source>How much relief shading the scan&apos;s own colours get: 0 is as photographed</source>
        <translation>स्कैन के अपने रंगों में उभार का कितना छायांकन मिले: 0 फ़ोटो जैसा है</translation>
    </message>
    <message>
        <source>Only natural colours and intensity are mixed with relief shading</source>
        <translation>केवल प्राकृतिक रंग और तीव्रता उभार के छायांकन के साथ मिलाए जाते हैं</translation>
    </message>
    <message>
        <source>Shading of colours: %1 %</source>
        <translation>रंगों का छायांकन: %1 %</translation>
    </message>
</context>
<context>
    <name>relievo::VoicePanel</name>
    <message>
        <source>Words a minute</source>
        <translation>प्रति मिनट शब्द</translation>
    </message>
    <message>
        <source>Volume of speech, percent</source>
        <translation>वाणी की आवाज़, प्रतिशत</translation>
    </message>
    <message>
        <source>Try the voice</source>
        <translation>आवाज़ आज़माएँ</translation>
    </message>
    <message>
        <source>Say it again</source>
        <translation>फिर से कहें</translation>
    </message>
    <message>
        <source>Who says what the hand meets</source>
        <translation>हाथ जो छूता है उसे कौन बताए</translation>
    </message>
    <message>
        <source>With a voice of its own, the program says what the hand meets and what commands find, and the screen reader is not told the same.</source>
        <translation>अपनी आवाज़ होने पर प्रोग्राम बताता है कि हाथ क्या छूता है और आदेशों का क्या परिणाम है; स्क्रीन रीडर को वही बात नहीं बताई जाती।</translation>
    </message>
    <message>
        <source>The screen reader</source>
        <translation>स्क्रीन रीडर</translation>
    </message>
    <message>
        <source>A voice of its own</source>
        <translation>अपनी आवाज़</translation>
    </message>
    <message>
        <source>Language of the voice</source>
        <translation>आवाज़ की भाषा</translation>
    </message>
    <message>
        <source>As the window</source>
        <translation>खिड़की जैसी</translation>
    </message>
    <message>
        <source>Exact with espeak-ng; other synthesizers have a scale of their own.</source>
        <translation>espeak-ng के साथ सटीक; अन्य सिंथेसाइज़र का अपना पैमाना है।</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Say again what was said last (Ctrl+Alt+S)</source>
        <translation>पिछली कही बात फिर से कहे (Ctrl+Alt+S)</translation>
    </message>
    <message>
        <source>Spoken by</source>
        <translation>बोलने वाला</translation>
    </message>
    <message>
        <source>Spoken language</source>
        <translation>बोली जाने वाली भाषा</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>आवाज़ का स्तर</translation>
    </message>
    <message>
        <source>Speech Dispatcher speaks.</source>
        <translation>Speech Dispatcher बोलता है।</translation>
    </message>
    <message>
        <source>espeak-ng speaks; Speech Dispatcher does not answer.</source>
        <translation>espeak-ng बोलता है; Speech Dispatcher उत्तर नहीं देता।</translation>
    </message>
    <message>
        <source>No voice can be heard.</source>
        <translation>कोई आवाज़ सुनाई नहीं दे सकती।</translation>
    </message>
    <message>
        <source>The program has no voice of its own now.</source>
        <translation>प्रोग्राम की अभी अपनी आवाज़ नहीं है।</translation>
    </message>
</context>
<context>
    <name>relievo::VoicePlugin</name>
    <message>
        <source>Voice</source>
        <translation>आवाज़</translation>
    </message>
    <message>
        <source>&amp;Repeat what was said</source>
        <translation>कही बात दोहराएँ (&amp;R)</translation>
    </message>
    <message>
        <source>Say again what was said last (Ctrl+Alt+S)</source>
        <translation>पिछली कही बात फिर से कहे (Ctrl+Alt+S)</translation>
    </message>
    <message>
        <source>In the voice&apos;s language of now; with a voice of its own.</source>
        <translation>आवाज़ की अभी की भाषा में; अपनी आवाज़ होने पर।</translation>
    </message>
    <message>
        <source>&amp;Louder speech</source>
        <translation>और तेज़ बोलें (&amp;L)</translation>
    </message>
    <message>
        <source>Sof&amp;ter speech</source>
        <translation>और धीमे बोलें (&amp;T)</translation>
    </message>
    <message>
        <source>Raise the volume of the voice by 3 decibels</source>
        <translation>आवाज़ 3 डेसिबल बढ़ाता है</translation>
    </message>
    <message>
        <source>Lower the volume of the voice by 3 decibels</source>
        <translation>आवाज़ 3 डेसिबल घटाता है</translation>
    </message>
</context>
<context>
    <name>relievo::WindowHost</name>
    <message>
        <source>%1 is too large for the memory and was not used. Make it coarser; it is laid over the whole map.</source>
        <translation>%1 स्मृति के लिए बहुत बड़ा है और काम में नहीं लिया गया। इसे मोटा करें; यह पूरे मानचित्र पर बिछाया जाता है।</translation>
    </message>
    <message>
        <source>Move and zoom</source>
        <translation>खिसकाएँ और पास लाएँ</translation>
    </message>
</context>
<context>
    <name>relievo::WindowMessages</name>
    <message>
        <source>%1 is saved</source>
        <translation>%1 सहेजी गई</translation>
    </message>
    <message>
        <source>The message is closed.</source>
        <translation>संदेश बंद है।</translation>
    </message>
</context>
<context>
    <name>relievo::WorkArea</name>
    <message>
        <source>Window</source>
        <translation>विंडो</translation>
    </message>
    <message>
        <source>View</source>
        <translation>दृश्य</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>स्टीरियो</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>माप</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>सुझाव</translation>
    </message>
    <message>
        <source>heights × %1   |   </source>
        <translation>ऊँचाइयाँ × %1   |   </translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>स्कैन</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>प्रकाश</translation>
    </message>
    <message>
        <source>OVERVIEW</source>
        <translation>अवलोकन</translation>
    </message>
    <message>
        <source>hand scale 1 : %1</source>
        <translation>हाथ का पैमाना 1 : %1</translation>
    </message>
    <message>
        <source>SCAN</source>
        <translation>स्कैन</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>बुकमार्क</translation>
    </message>
    <message>
        <source>DETAIL   |   Resolution %1 of %2</source>
        <translation>विवरण   |   रिज़ॉल्यूशन %2 में से %1</translation>
    </message>
</context>
</TS>
